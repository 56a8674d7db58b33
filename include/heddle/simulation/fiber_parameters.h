#ifndef heddle_simulation_fiber_parameters_h
#define heddle_simulation_fiber_parameters_h

#include <heddle/beam/element.h>

#include <deal.II/base/parameter_acceptor.h>

#include <memory>
#include <string>

namespace Heddle
{
  namespace Simulation
  {
    using namespace dealii;

    /** Material and finite element of the fibers. */
    class FiberParameters : public ParameterAcceptor
    {
    public:
      FiberParameters(const std::string &section = "/Fiber");

      std::unique_ptr<Beam::Element>
      element() const;

      /**
       * Constants of the section of a fiber of this radius [mm]. If it stands
       * for filaments of a smaller one, it bends and twists as they do side by
       * side: $(R / r)^2$ filaments have the area of the fiber, and the part
       * $(r / R)^2$ of its second moments.
       */
      Beam::Section
      section(const double radius, const double filament_radius = 0.) const;

      std::string  element_name        = "hermite";
      unsigned int degree              = 1;
      unsigned int elements_per_fiber  = 36;
      double       axial_modulus       = 72400.;
      double       shear_modulus       = 0.;
      double       poisson_ratio       = 0.22;
      double       axial_stiffness     = 0.;
      double       bending_stiffness   = 0.;
      double       torsional_stiffness = 0.;
      double       shear_stiffness     = 0.;
      double       section_stiffness   = 0.;
    };
  } // namespace Simulation
} // namespace Heddle

#endif
