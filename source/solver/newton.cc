#include <heddle/solver/newton.h>

namespace Heddle
{
  namespace Solver
  {
    Newton::Newton(const NewtonLimits           &limits,
                   const LinearSolverParameters &linear_parameters,
                   Log                          &log,
                   SectionTimer                 &timer,
                   StopRequest                  &stop)
      : limits(limits)
      , linear_parameters(linear_parameters)
      , log(log)
      , timer(timer)
      , stop(stop)
    {
    }



    NewtonTools &
    Newton::tools_for(const System::State &state)
    {
      if (!tools || field_version != state.field_version())
        {
          tools.reset();
          tools = std::make_unique<NewtonTools>(
            state, linear_parameters, limits.damping);
          field_version = state.field_version();
        }
      return *tools;
    }



    NewtonResult
    Newton::solve(System::State           &state,
                  const Contributions     &contributions,
                  const Aim                aim,
                  const System::Increment &guess)
    {
      NewtonTools &shared = tools_for(state);
      Equations    equations(state, contributions, shared.system, timer);
      NewtonSearch search(equations, shared, limits, aim, log, timer, stop);
      const NewtonResult result = search.run(guess);

      shared.give_memory_back();
      return result;
    }



    double
    Newton::residual_ratio(System::State       &state,
                           const Contributions &contributions)
    {
      Equations equations(state, contributions, tools_for(state).system, timer);
      return equations.judge_without_tangent().ratio;
    }
  } // namespace Solver
} // namespace Heddle
