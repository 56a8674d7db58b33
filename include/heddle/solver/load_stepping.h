#ifndef heddle_solver_load_stepping_h
#define heddle_solver_load_stepping_h

#include <heddle/base/archive.h>

#include <deal.II/base/parameter_acceptor.h>

#include <algorithm>
#include <string>
#include <vector>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    /** How a load factor goes from 0 to 1. */
    struct LoadPlan
    {
      double initial_step  = 1.; /**< [-] */
      double largest_step  = 1.; /**< [-] */
      double smallest_step = 1.; /**< [-] */

      /** A step of at most this many iterations lets the next one grow. */
      unsigned int easy_iterations = 8;

      /** Load factors that are hit exactly, beside 1, ascending [-]. */
      std::vector<double> points;

      /** Hit @p more of them as well. */
      void
      reach(const std::vector<double> &more);
    };



    class LoadSteppingParameters : public ParameterAcceptor
    {
    public:
      LoadSteppingParameters(const std::string &section = "/Load stepping");

      /** The plan, checked: throws InputError if steps or points disagree. */
      LoadPlan
      plan() const;

    private:
      LoadPlan entries;
    };



    /**
     * Adaptive steps of the load factor: halved when no equilibrium is found,
     * half as long again after a step that was easy, or when some steps in a
     * row were good after a cut, up to what they were before; and divided
     * evenly before a requested point, so that none is left with a sliver.
     */
    class LoadStepping
    {
    public:
      LoadStepping(const LoadPlan &plan);

      /**
       * Take a step to load factor 0 before all others: what is not in balance
       * there finds its equilibrium before anything moves. It is not halved.
       */
      void
      begin_at_zero()
      {
        at_zero = true;
      }

      /** Whether there was a good step. */
      bool
      has_begun() const
      {
        return begun;
      }

      /** The load factor of the last good step; 0 at first [-]. */
      double
      reached() const
      {
        return last;
      }

      bool
      finished() const
      {
        return last >= 1.;
      }

      /** The load factor of the next step. @pre Not finished. */
      double
      next() const;

      /** The step to next() was good and took so many Newton iterations. */
      void
      accept(const unsigned int newton_iterations);

      /** It failed. Return whether a shorter step is allowed. */
      bool
      cut_back();

      /** Try the step as long as it was before it was cut. */
      void
      restore()
      {
        step   = std::max(step, uncut);
        n_good = 0;
      }

      /** @note Collective. */
      void
      save(ArchiveWriter &archive) const;
      void
      load(const ArchiveReader &archive);

    private:
      /** Where the steps before the next requested point end, and how many. */
      double
      next_point() const;
      unsigned int
      n_steps_to(const double point) const;

      const LoadPlan plan;
      bool           at_zero = false; /**< the next step is to 0 */
      bool           begun   = false;
      double         last    = 0.;
      double         step;
      double         uncut    = 0.; /**< the step before it was cut */
      double         failed   = 0.; /**< load factor that was not reached */
      unsigned int   n_good   = 0;  /**< steps since the last cut or growth */
      unsigned int   patience = 0;  /**< good steps before it grows again */
    };
  } // namespace Solver
} // namespace Heddle

#endif
