#ifndef heddle_solver_newton_search_h
#define heddle_solver_newton_search_h

#include <heddle/base/log.h>
#include <heddle/base/signals.h>
#include <heddle/base/timer.h>
#include <heddle/solver/equations.h>
#include <heddle/solver/fiber_damping.h>
#include <heddle/solver/linear_solver.h>
#include <heddle/solver/newton_parameters.h>
#include <heddle/solver/secants.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    /** What Newton's method did. */
    struct NewtonResult
    {
      bool         converged         = false;
      unsigned int iterations        = 0;
      unsigned int factorizations    = 0;
      unsigned int linear_iterations = 0;
      double       residual_ratio    = 0.;
      double       increment         = 0.; /**< largest motion, in radii [-] */
      std::string  obstacle;               /**< why not converged, in words */
      bool         used_up = false; /**< all iterations that are allowed */

      /** In equilibrium, but the tangent is not positive definite: a small
       * disturbance leads elsewhere. Where nothing touches. */
      bool unstable = false;
    };

    /**
     * How far to go, and where from: to equilibrium, or only until forces
     * balance on average and fibers move by little, after which friction can
     * take over. From where fibers start in the first place nonsmooth terms are
     * soft, even if fibers hardly touch there and forces seem to balance; after
     * calm they are not softened again; else where forces are far from balance.
     */
    enum class Aim
    {
      equilibrium,
      calm_from_start,
      equilibrium_from_start,
      equilibrium_after_calm
    };

    /** What one search of an equilibrium after the other works with. */
    struct NewtonTools
    {
      NewtonTools(const System::State          &state,
                  const LinearSolverParameters &linear_parameters,
                  const double                  first_damping);

      /**
       * Give back the memory of couplings and of the blocks of fibers, which
       * the next search makes anew in any case: output and checkpoints have use
       * for it. The tangent is none from then on. Small scenes keep theirs.
       */
      void
      give_memory_back();

      System::BlockSystem system;
      LinearSolver        linear_solver;
      FiberDamping        damping;
      Secants             secants;
    };

    /**
     * One search of an equilibrium by Newton's method, see Newton: its
     * iterations, and what one of them has to know of those before.
     *
     * All members are collective.
     */
    class NewtonSearch
    {
    public:
      NewtonSearch(Equations          &equations,
                   NewtonTools        &tools,
                   const NewtonLimits &limits,
                   const Aim           aim,
                   Log                &log,
                   SectionTimer       &timer,
                   StopRequest        &stop);

      /** Begin by a @p guess of the motion of owned blocks, if there is one. */
      NewtonResult
      run(const System::Increment &guess);

    private:
      /** Whether the search goes on, and from where. */
      enum class Verdict
      {
        go_on,
        begin_again,
        ended
      };

      /** Whether nonsmooth terms, if there are any, have to begin soft now. */
      bool
      wants_softness() const;

      /** Prepare, assemble and judge the terms as they are. */
      void
      evaluate();

      /** The same of a new configuration, in which terms may have to begin
       * soft, and what follows from it for this iteration. */
      void
      measure();

      /** Terms have changed: prepare and assemble them anew. */
      void
      renew();

      /** Whether the search is at its end, or has to begin afresh. */
      Verdict
      judge();

      /** Likewise, where forces do not balance. */
      Verdict
      judge_progress(const bool balanced, const bool still);

      /** From the start, held back as where fibers touch, for @p reason. */
      void
      begin_again(const std::string &reason);

      /** Whether unbalanced forces still get smaller, on average. */
      bool
      forces_fall() const;

      bool
      is_balanced() const;

      /** Whether all prescribed motion is done. */
      bool
      is_in_place() const
      {
        return residual.pending <= Equations::reached * equations.length_scale;
      }

      /** Whether fibers are damped, and steps cut. */
      bool
      is_held() const
      {
        return nonsmooth || guarded;
      }

      /** Whether the tangent of what is in balance has negative eigenvalues.
       * Leaves the residual assembled. */
      bool
      is_unstable();

      /** Where the iteration is calm nonsmooth terms harden or adapt. */
      void
      harden_or_adapt();

      /** Whether the steps before tell of the stiffness, for the next one. */
      bool
      may_learn() const;

      /** Find the increment, by the best tangent that there is. */
      void
      find_increment();

      /** Solve the system as it is assembled for the increment. */
      void
      solve_linear_system();

      /** Go along the increment; whether the search goes on. */
      bool
      take_step();

      /**
       * The part of the increment that may be taken, and is of use, where
       * fibers are held back: no more than @p longest if it is searched.
       */
      double
      step_length(const double longest, const bool search);

      /** Which fiber keeps the forces from being in balance, and where. */
      std::string
      describe_imbalance() const;

      /** Of the surface of a fiber by the increment, in radii. */
      double
      largest_motion() const;

      /** Root mean square of that of nodes of fibers. */
      double
      mean_motion() const;

      void
      report() const;

      /** Why a search with prescribed motion ends before that is done. */
      static constexpr const char *not_arrived =
        "supports do not get to where they are to be: contact, or elements of "
        "fibers or cells of the matrix that would turn inside out, allow short "
        "steps only";

      Equations          &equations;
      NewtonTools        &tools;
      const NewtonLimits &limits;
      const Aim           aim;
      Log                &log;
      SectionTimer       &timer;
      StopRequest        &stop;

      NewtonResult      result;
      Residual          residual;
      LinearResult      linear;
      System::Increment increment;
      unsigned int      iteration = 0;

      std::vector<Tensor<1, 3>> start;           /**< after the guess */
      bool                      guessed = false; /**< it was followed */
      unsigned int              limit; /**< the last iteration allowed */

      bool   nonsmooth        = false; /**< any term, in this iteration */
      bool   calm             = false; /**< little moves, in this iteration */
      bool   guarded          = false; /**< held back though nothing touches */
      bool   softened         = false; /**< nonsmooth terms have been soft */
      bool   may_be_geometric = true;  /**< contact, in the tangent */
      bool   geometric        = false; /**< it is, in this iteration */
      bool   learning         = false; /**< from steps before, likewise */
      double ratio_before     = 0.;    /**< of the residual, an iteration ago */
      double wanted           = 0.;    /**< by the last system, in radii */

      /** Unbalanced ones since terms have adapted, by iteration [N]. */
      std::vector<double> mean_forces;

      unsigned int adapted_at = 0; /**< the last iteration that terms did */
      unsigned int n_pending  = 0; /**< with little left of prescribed motion */
      unsigned int n_objections = 0; /**< at rest, and a term objects */
      unsigned int n_whole      = 0; /**< steps that were not shortened */
      unsigned int n_cut        = 0; /**< steps that were much so, in a row */
    };
  } // namespace Solver
} // namespace Heddle

#endif
