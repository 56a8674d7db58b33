#ifndef heddle_solver_newton_h
#define heddle_solver_newton_h

#include <heddle/base/log.h>
#include <heddle/base/signals.h>
#include <heddle/base/timer.h>
#include <heddle/solver/fiber_damping.h>
#include <heddle/solver/line_search.h>
#include <heddle/solver/linear_solver.h>
#include <heddle/solver/newton_parameters.h>
#include <heddle/solver/residual.h>
#include <heddle/solver/secants.h>

#include <memory>
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
     * How far to go: to equilibrium, or only until forces balance on average
     * and fibers move by little, after which friction can take over; or from
     * there to equilibrium, where rough terms are not softened again.
     */
    enum class Aim
    {
      equilibrium,
      calm,
      equilibrium_after_calm
    };

    /**
     * Newton's method on the sum of all contributions.
     *
     * Without rough terms (contact) it takes full steps, as mixed integration
     * points want it. With them fibers are damped one by one, and steps go to
     * where the energy stops falling. From a state that is far from equilibrium
     * rough terms begin soft and harden in steps whenever the forces balance
     * on average: each of these problems is nearly solved by the one before.
     * An equilibrium that full steps have found and that is not stable is left
     * for one that is, by steps as with rough terms from the start.
     */
    class Newton
    {
    public:
      Newton(const NewtonLimits           &parameters,
             const LinearSolverParameters &linear_parameters,
             const MPI_Comm                communicator,
             Log                          &log,
             SectionTimer                 &timer,
             StopRequest                  &stop);

      /**
       * Bring @p state to equilibrium, or as far as @p aim says. A @p guess of
       * the motion of the owned blocks to that equilibrium is followed first.
       * @note Collective. Throws Stopped on request.
       */
      NewtonResult
      solve(System::State           &state,
            const Contributions     &contributions,
            const Aim                aim   = Aim::equilibrium,
            const System::Increment &guess = {});

      /**
       * The residual ratio of the current configuration, assembled anew.
       * @note Collective.
       */
      double
      residual_ratio(System::State &state, const Contributions &contributions);

      /** The residual as last assembled, for reactions. */
      const System::BlockSystem *
      system() const
      {
        return block_system.get();
      }

    private:
      /** Prescribed motion that is below round-off, in radii. */
      static constexpr double reached = 1e-9;

      /** Create the linear system for these fields, if it is not there. */
      void
      begin(const System::State &state);

      /** Below them, forces are the last digits of positions. */
      void
      find_negligible_forces(const System::State &state,
                             const Contributions &contributions);

      /**
       * Go along @p guess in parts that all terms allow, as far as it is
       * credible; return whether it was followed at all.
       */
      bool
      follow(System::State           &state,
             const Contributions     &contributions,
             const System::Increment &guess);

      void
      collect_constraints(const System::State &state,
                          const Contributions &contributions);

      /** Bring all terms and the constraints up to date. */
      void
      update(System::State &state, const Contributions &contributions);

      /** The same, and the pattern of the tangent. */
      void
      prepare(System::State &state, const Contributions &contributions);

      void
      assemble(System::State                  &state,
               const Contributions            &contributions,
               const System::BlockSystem::Want want =
                 System::BlockSystem::Want::residual_and_tangent);

      /** Why what is in balance is no equilibrium, by the first term that
       * objects, or nothing. */
      std::string
      first_objection(const System::State &state,
                      const Contributions &contributions) const;

      /** Whether the tangent of what is in balance has negative eigenvalues.
       * Leaves the residual assembled. */
      bool
      is_unstable(System::State &state, const Contributions &contributions);

      /**
       * The step of all blocks that the system as assembled asks for, by what
       * steps before have told if they are to be learned from.
       */
      LinearResult
      solve_linear_system(const bool         rough,
                          const Aim          aim,
                          const bool         learn,
                          System::Increment &increment);

      /** How soft rough terms are, from 1 to 0. */
      void
      set_softness(const Contributions &contributions, const double value);

      /** Whether forces of rough terms turn in the tangent. */
      void
      let_forces_turn(const Contributions &contributions, const bool wanted);

      /** Let terms improve their guesses; whether one did. */
      bool
      adapt(System::State &state, const Contributions &contributions);

      Residual
      judge(const Contributions &contributions) const;

      bool
      is_balanced(const Residual &residual) const;

      /** Which fiber keeps the forces from being in balance, and where. */
      std::string
      describe_imbalance(const Contributions &contributions,
                         const double         ratio,
                         const double         motion) const;

      /**
       * The part of @p increment that may be taken, and is of use: no more than
       * @p longest. It is the solution of a symmetric system or of one that is
       * far from it.
       */
      double
      step_length(System::State           &state,
                  const Contributions     &contributions,
                  const System::Increment &increment,
                  const double             longest,
                  const bool               search,
                  const bool               unsymmetric);

      /**
       * The part of @p increment that may be taken where no fibers are near
       * each other: they are moved along it as far as is known, and searched
       * again, until some are near. A new system would ask for the same way.
       * Ghosts of @p increment follow those of @p state, which stays.
       */
      double
      walk(System::State       &state,
           const Contributions &contributions,
           System::Increment   &increment);

      double
      largest_motion(const System::State     &state,
                     const System::Increment &increment) const;

      void
      report(const unsigned int   iteration,
             const Residual      &residual,
             const NewtonResult  &result,
             const Contributions &contributions) const;

      const NewtonLimits           &parameters;
      const LinearSolverParameters &linear_parameters;
      const MPI_Comm                communicator;
      Log                          &log;
      SectionTimer                 &timer;
      StopRequest                  &stop;

      std::unique_ptr<System::BlockSystem> block_system;
      std::unique_ptr<LinearSolver>        linear_solver;
      std::unique_ptr<FiberDamping>        damping;
      std::unique_ptr<Secants>             secants;
      unsigned int                         ghost_version = 0;
      unsigned int                         field_version = 0;
      std::vector<System::Constraint>      constraints;
      double                               softness     = 0.;
      double                               length_scale = 1.;

      /** Forces on nodes below these are last digits [N]. */
      System::NodeStiffness negligible;
    };
  } // namespace Solver
} // namespace Heddle

#endif
