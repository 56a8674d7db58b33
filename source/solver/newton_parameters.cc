#include <heddle/solver/newton_parameters.h>

namespace Heddle
{
  namespace Solver
  {
    NewtonParameters::NewtonParameters(const std::string &section)
      : ParameterAcceptor(section)
    {
      add_parameter(
        "Residual tolerance",
        given_residual,
        "Largest unbalanced nodal force that is accepted, over the "
        "mean contact force, which counts as no less than a "
        "hundredth of the largest in the stage and a thousandth of "
        "the largest force of supports, or over the largest of the "
        "loads, or over the "
        "largest force where nothing touches; 0: 0.01 for a weave "
        "or a measured fabric, 1e-5 for centerlines. A reaction that "
        "is the small difference of large forces, as those of "
        "stiff fibers in a soft matrix, has the error of these "
        "[-].",
        prm,
        Patterns::Double(0., 1.));
      add_parameter("Increment tolerance",
                    given_increment,
                    "Largest motion in the last iteration that is accepted, as "
                    "a multiple of the smallest fiber radius; 0: 0.1 for a "
                    "weave or a measured fabric, 1e-3 for centerlines [-].",
                    prm,
                    Patterns::Double(0., 1.));
      add_parameter(
        "Maximum iterations",
        given_iterations,
        "Iterations after which a load step is given up; 0: 500 "
        "for a weave, a measured fabric and centerlines that are "
        "straight when free, or before loads begin, 60 for others, and "
        "up to 500 as long as fibers touch and unbalanced forces fall or "
        "penalties grow, or "
        "before their shortest step is given up. "
        "As many again for fibers that are held back since they "
        "snap or buckle [-].",
        prm,
        Patterns::Integer(0));
      add_parameter(
        "Damping",
        damping,
        "Stiffness per length that holds the nodes back in the "
        "first iteration from an unsettled state, in units of "
        "E A / R^2; then it adapts to how each fiber moves. With 0 "
        "nothing is ever held back. Without contact and plates only "
        "searches for a stable equilibrium are [-].",
        prm,
        Patterns::Double(0.));
    }



    void
    NewtonParameters::choose_for(const bool fabric,
                                 const bool straight_when_free)
    {
      residual_tolerance   = given_residual > 0. ? given_residual
                             : fabric            ? 0.01
                                                 : 1e-5;
      increment_tolerance  = given_increment > 0. ? given_increment
                             : fabric             ? 0.1
                                                  : 1e-3;
      const bool from_afar = fabric || straight_when_free;
      max_iterations       = given_iterations > 0 ? given_iterations
                             : from_afar          ? 500
                                                  : 60;
      most_iterations      = given_iterations > 0 ? given_iterations : 500;
    }
  } // namespace Solver
} // namespace Heddle
