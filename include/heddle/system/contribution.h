#ifndef heddle_system_contribution_h
#define heddle_system_contribution_h

#include <heddle/base/archive.h>
#include <heddle/system/block_system.h>
#include <heddle/system/state.h>

#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Heddle
{
  namespace System
  {
    /** Motion of the local blocks, ghosts included. */
    using Increment = std::vector<Tensor<1, 3>>;

    /**
     * What a node resists at most [N/mm]: its position has no digits for forces
     * below that times the last one.
     */
    struct NodeStiffness
    {
      std::vector<double> of_fibers; /**< of nodes of a fiber, by number */
      double              of_matrix = 0.;
    };

    /**
     * One physical term of the equilibrium. A scene is the list of its
     * contributions: what is not in the list costs nothing. The solver knows
     * this interface and nothing else of the physics.
     *
     * All members are collective unless said otherwise.
     */
    class Contribution
    {
    public:
      virtual ~Contribution() = default;

      /** "fiber contact": for logs, timers, the summary and tests. */
      virtual std::string
      name() const = 0;

      /**
       * A step begins, or is searched afresh: the load factor of the state is
       * the new one. There may be several calls for one load factor.
       */
      virtual void
      begin_step(State &)
      {
      }

      /**
       * A stage begins in this configuration: motions that are prescribed from
       * now on count from it.
       * @note Collective.
       */
      virtual void
      begin_stage(const State &)
      {
      }

      /**
       * The configuration changed: bring what depends on it up to date, contact
       * elements for instance. May change the ghosts of the state.
       */
      virtual void
      update(State &)
      {
      }

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
      update_trial(State &)
      {
      }

      /** Whether the pattern that was last given no longer suffices. */
      virtual bool
      needs_new_pattern() const
      {
        return false;
      }

      /** Append the motions that this term prescribes in the current state. */
      virtual void
      constrain(const State &, std::vector<Constraint> &) const
      {
      }

      /** Say which blocks assemble() may couple. */
      virtual void
      add_pattern(const State &state, BlockPattern &pattern) = 0;

      /** Add residual and, if wanted, tangent. */
      virtual void
      assemble(const State &state, BlockSystem &system) = 0;

      /**
       * A step is about to be taken: @p increment is all of it, of the
       * solution of the linear system the part that the line search chose.
       */
      virtual void
      predict(const State &, const Increment &)
      {
      }

      /**
       * Largest factor by which the step @p increment may be taken, perhaps
       * more than 1. Local: the solver takes the smallest over ranks and
       * contributions.
       */
      virtual double
      largest_step(const State &, const Increment &) const
      {
        return std::numeric_limits<double>::max();
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

      /** Raise @p stiffness to what this term makes nodes resist. Local. */
      virtual void
      raise_stiffness(NodeStiffness &) const
      {
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
       * From 1 down to 0: a nonsmooth term may be so much smoother than it is,
       * while the iteration is on its way. Equilibrium is judged at 0.
       */
      virtual void
      set_softness(const double)
      {
      }

      /**
       * Whether the tangent of a nonsmooth term has the part that its forces
       * turn by, which close to equilibrium makes it exact, and may make it
       * indefinite.
       */
      virtual void
      set_geometric_stiffness(const bool)
      {
      }

      /**
       * Whether this term is not smooth enough for Newton's full step: then the
       * solver looks for a shorter one with the help of slope_and_curvature().
       */
      virtual bool
      is_nonsmooth() const
      {
        return false;
      }

      /**
       * Local part of the derivative of this term's energy along @p increment
       * in the current configuration, and of its second derivative by the
       * tangent. Asked of nonsmooth terms only, without assembly.
       */
      virtual std::pair<double, double>
      slope_and_curvature(const State &, const Increment &) const
      {
        return {0., 0.};
      }

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
       * What keeps the current state from being accepted although it is in
       * equilibrium ("penetration 0.04 above 0.02"), or nothing.
       */
      virtual std::string
      objection(const State &) const
      {
        return "";
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

      /**
       * Equilibrium was found, or a loaded stage begins: @p system has the
       * forces, the reactions of what is held among them. Whether the step
       * counts is for accept_step() to say.
       */
      virtual void
      observe(const BlockSystem &)
      {
      }

      /** A force typical of this term, to judge residuals by, or 0 [N]. */
      virtual double
      typical_force() const
      {
        return 0.;
      }

      /** Numbers for the log line of an iteration, "active 1843". */
      virtual std::string
      status() const
      {
        return "";
      }

      /** Numbers for the summary and the history, by name with unit. */
      virtual void
      report(const State &, std::map<std::string, double> &) const
      {
      }

      /** The step is about to count; the last one still is accepted(). */
      virtual void
      accept_step(const State &)
      {
      }

      virtual void
      reject_step(State &)
      {
      }

      /**
       * Write to a checkpoint, under "name()/...", what a resumed run must
       * know and cannot compute from the state, and take it back from there.
       */
      virtual void
      save(ArchiveWriter &, const State &) const
      {
      }

      virtual void
      load(const ArchiveReader &, const State &)
      {
      }

      /**
       * Take what is useful from the checkpoint of another run, which ended in
       * the configuration where this one begins.
       */
      virtual void
      load_initial(const ArchiveReader &, const State &)
      {
      }
    };
  } // namespace System
} // namespace Heddle

#endif
