#include <heddle/simulation/ordering_stage.h>

#include <algorithm>

namespace Heddle
{
  namespace Simulation
  {
    namespace
    {
      /** Overlap with which ordinary contact can begin, over the radius. */
      constexpr double left_over = 0.3;



      /**
       * Copies of all fibers: those that cross may have to pass each other by
       * more than fibers that touch do.
       */
      void
      hold_all_fibers(System::State &state)
      {
        std::vector<System::GhostFiber> ghosts;
        for (unsigned int f = 0; f < state.space.n_fibers(); ++f)
          if (!state.space.owns(f))
            ghosts.push_back({f, state.space.all_nodes(f)});
        state.set_ghost_fibers(ghosts);
      }



      void
      count(const Solver::NewtonResult &solved, OrderingResult &result)
      {
        result.newton_iterations += solved.iterations;
        result.factorizations += solved.factorizations;
        result.linear_iterations += solved.linear_iterations;
      }
    } // namespace



    OrderingParameters::OrderingParameters(const std::string &section)
      : ParameterAcceptor(section)
    {
      add_parameter("Ordering steps",
                    n_steps,
                    "In how many steps yarns that run through each other are "
                    "brought onto their sides, at least 1. Inactive unless "
                    "Weave/Start is 'interpenetrating' [-].",
                    prm,
                    Patterns::Integer(1));
      add_parameter("Iterations per step",
                    iterations,
                    "Newton iterations in each of these steps, at least 1. "
                    "Inactive like the steps [-].",
                    prm,
                    Patterns::Integer(1));
      add_parameter("Clearance",
                    clearance,
                    "Height that is enforced between fibers that cross, beyond "
                    "that at which they touch, over the smallest radius. "
                    "Inactive like the steps [-].",
                    prm,
                    Patterns::Double(0., 10.));
      add_parameter("Damping",
                    damping,
                    "Stiffness per length that holds nodes back meanwhile, in "
                    "units of E A / R^2. Inactive like the steps [-].",
                    prm,
                    Patterns::Double(0.));
    }



    OrderingStage::OrderingStage(
      const OrderingParameters             &parameters,
      const Solver::LinearSolverParameters &linear_parameters,
      Log                                  &log,
      SectionTimer                         &timer,
      StopRequest                          &stop)
      : parameters(parameters)
      , linear_parameters(linear_parameters)
      , log(log)
      , timer(timer)
      , stop(stop)
    {
    }



    OrderingResult
    OrderingStage::run(System::State                      &state,
                       const Solver::Contributions        &contributions,
                       Contributions::FiberContact        &contact,
                       Contributions::CrossingEnforcement &enforcement)
    {
      hold_all_fibers(state);
      contact.restrict_to([&enforcement](unsigned int a, unsigned int b) {
        return !enforcement.enforces(a, b);
      });
      contact.update(state);
      const OrderingResult result =
        lower_allowance(state, contributions, enforcement);

      contact.restrict_to([](unsigned int, unsigned int) { return true; });
      state.accept();
      return result;
    }



    OrderingResult
    OrderingStage::lower_allowance(
      System::State                      &state,
      const Solver::Contributions        &contributions,
      Contributions::CrossingEnforcement &enforcement)
    {
      Solver::NewtonLimits limits;
      limits.max_iterations = limits.most_iterations = parameters.iterations;
      limits.damping                                 = parameters.damping;
      Solver::Newton newton(limits, linear_parameters, log, timer, stop);

      // Steps beyond the last hold what they have until the fibers followed.
      const double   radius  = state.space.smallest_radius();
      const double   first   = enforcement.largest_overlap(state);
      const double   last    = -parameters.clearance * radius;
      double         overlap = first;
      OrderingResult result;
      while (
        result.steps < parameters.n_steps ||
        (overlap > left_over * radius && result.steps < 2 * parameters.n_steps))
        {
          ++result.steps;
          const double progress =
            std::min(1., double(result.steps) / parameters.n_steps);
          enforcement.set_allowance(first + progress * (last - first));
          for (const auto &contribution : contributions)
            contribution->begin_step(state);
          count(newton.solve(state, contributions), result);
          overlap                = enforcement.largest_overlap(state);
          result.least_clearance = -overlap / radius;
        }
      return result;
    }
  } // namespace Simulation
} // namespace Heddle
