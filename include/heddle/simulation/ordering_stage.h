#ifndef heddle_simulation_ordering_stage_h
#define heddle_simulation_ordering_stage_h

#include <heddle/contributions/crossing_enforcement.h>
#include <heddle/contributions/fiber_contact.h>
#include <heddle/solver/newton.h>

#include <deal.II/base/parameter_acceptor.h>

namespace Heddle
{
  namespace Simulation
  {
    using namespace dealii;

    class OrderingParameters : public ParameterAcceptor
    {
    public:
      OrderingParameters(
        const std::string &section = "/Initial configuration/Ordering");

      unsigned int n_steps    = 24;
      unsigned int iterations = 2;
      double       clearance  = 0.1;
      double       damping    = 3e-4;
    };



    /** What it took to bring the yarns onto their sides. */
    struct OrderingResult
    {
      unsigned int steps             = 0;
      unsigned int newton_iterations = 0;
      unsigned int factorizations    = 0;
      unsigned int linear_iterations = 0;

      /**
       * Least height between fibers that cross, less that at which they touch,
       * over the radius; above -2 all of them are in order [-].
       */
      double least_clearance = 0.;
    };



    /**
     * First part of the initial configuration from yarns that run through each
     * other: in small steps the directions of contact at the crossings are
     * enforced, until each fiber is on its side of all that it crosses.
     *
     * Meanwhile ordinary contact acts within families of yarns only. Afterwards
     * it acts between all fibers, and the enforcement is left: what follows is
     * the search for equilibrium, as from any other start.
     *
     * Equilibrium is not waited for: a step that found none is as good.
     */
    class OrderingStage
    {
    public:
      OrderingStage(const OrderingParameters             &parameters,
                    const Solver::LinearSolverParameters &linear_parameters,
                    Log                                  &log,
                    SectionTimer                         &timer,
                    StopRequest                          &stop);

      /**
       * Order the yarns that @p enforcement knows of. @p contributions is all
       * that acts, @p contact and @p enforcement included. Every rank holds
       * copies of all fibers in the end.
       *
       * @note Collective. Throws Stopped on request.
       */
      OrderingResult
      run(System::State                      &state,
          const Solver::Contributions        &contributions,
          Contributions::FiberContact        &contact,
          Contributions::CrossingEnforcement &enforcement);

    private:
      OrderingResult
      lower_allowance(System::State                      &state,
                      const Solver::Contributions        &contributions,
                      Contributions::CrossingEnforcement &enforcement);

      const OrderingParameters             &parameters;
      const Solver::LinearSolverParameters &linear_parameters;
      Log                                  &log;
      SectionTimer                         &timer;
      StopRequest                          &stop;
    };
  } // namespace Simulation
} // namespace Heddle

#endif
