#ifndef heddle_system_nonsmooth_contribution_h
#define heddle_system_nonsmooth_contribution_h

#include <heddle/system/contribution.h>

#include <limits>
#include <utility>
#include <vector>

namespace Heddle
{
  namespace System
  {
    /**
     * A term whose elements come and go as fibers move, and whose stiffness
     * jumps with them: contact, friction, order at crossings. It searches for
     * its elements in the configuration of each iteration, and tells the solver
     * how far Newton's step may be taken.
     *
     * All members are collective unless said otherwise.
     */
    class NonsmoothContribution : public Contribution
    {
    public:
      /**
       * The configuration changed: bring what depends on it up to date, contact
       * elements for instance. May change the ghosts of the state.
       */
      virtual void
      update(State &state) = 0;

      /**
       * An iteration begins in the configuration that this was brought up to:
       * what is about to go wrong may be prevented.
       */
      virtual void
      begin_iteration(State &)
      {
      }

      /**
       * What update() does, for a configuration that is only tried: what was
       * searched stays, and so do the ghosts.
       */
      virtual void
      update_trial(State &state) = 0;

      /** Whether the pattern that was last given no longer suffices. */
      virtual bool
      needs_new_pattern() const
      {
        return false;
      }

      /**
       * The same of what update() knows of: further along @p increment fibers
       * might meet unseen.
       */
      virtual double
      searched_step(const State &, const Increment &) const
      {
        return std::numeric_limits<double>::max();
      }

      /**
       * Whether a configuration that was only guessed, and update()d, may be
       * gone on from: not where fibers may come out of each other on the wrong
       * side. The same on all ranks.
       */
      virtual bool
      is_credible() const
      {
        return true;
      }

      /**
       * From 1 down to 0: this term may be so much smoother than it is,
       * while the iteration is on its way. Equilibrium is judged at 0.
       */
      virtual void
      set_softness(const double)
      {
      }

      /**
       * Whether the tangent has the part that forces turn by, which close to
       * equilibrium makes it exact, and may make it indefinite.
       */
      virtual void
      set_geometric_stiffness(const bool)
      {
      }

      /**
       * Whether this term is not smooth enough for Newton's full step as things
       * are: then the solver looks for a shorter one with the help of
       * slope_and_curvature(). Contact is where fibers are near each other.
       */
      virtual bool
      is_nonsmooth() const
      {
        return true;
      }

      /**
       * Local part of the derivative of this term's energy along @p increment
       * in the current configuration, and of its second derivative by the
       * tangent, without assembly.
       */
      virtual std::pair<double, double>
      slope_and_curvature(const State     &state,
                          const Increment &increment) const = 0;

      /**
       * The iteration calmed down: improve what was only guessed so far, such
       * as penalties. Return whether the equilibrium changed by that.
       */
      virtual bool
      adapt(const State &)
      {
        return false;
      }

      /**
       * Other fibers that this term makes act on the owned fiber @p f next to
       * its @p node. Local.
       */
      virtual std::vector<unsigned int>
      contacting_fibers(const unsigned int, const unsigned int) const
      {
        return {};
      }
    };
  } // namespace System
} // namespace Heddle

#endif
