#ifndef heddle_solver_newton_h
#define heddle_solver_newton_h

#include <heddle/solver/newton_search.h>

#include <memory>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    /**
     * Newton's method on the sum of all contributions.
     *
     * Without nonsmooth terms (contact) it takes full steps, as mixed
     * integration points want it. With them fibers are damped one by one, and
     * steps go to where the energy stops falling. From a state that is far from
     * equilibrium nonsmooth terms begin soft and harden in steps whenever the
     * forces balance on average: each of these problems is nearly solved by the
     * one before. An equilibrium that full steps have found and that is not
     * stable is left for one that is, by steps as with nonsmooth terms from the
     * start.
     */
    class Newton
    {
    public:
      Newton(const NewtonLimits           &limits,
             const LinearSolverParameters &linear_parameters,
             Log                          &log,
             SectionTimer                 &timer,
             StopRequest                  &stop);

      /** From now on contributions are others, and so is the pattern. */
      void
      begin_stage()
      {
        if (tools)
          tools->system.forget_pattern();
      }

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
        return tools ? &tools->system : nullptr;
      }

    private:
      /** The tools for the fields that @p state has. */
      NewtonTools &
      tools_for(const System::State &state);

      const NewtonLimits           &limits;
      const LinearSolverParameters &linear_parameters;
      Log                          &log;
      SectionTimer                 &timer;
      StopRequest                  &stop;

      std::unique_ptr<NewtonTools> tools;
      unsigned int                 field_version = 0;
    };
  } // namespace Solver
} // namespace Heddle

#endif
