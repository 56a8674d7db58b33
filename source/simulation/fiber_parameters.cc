#include <heddle/simulation/fiber_parameters.h>

namespace Heddle
{
  namespace Simulation
  {
    FiberParameters::FiberParameters(const std::string &section)
      : ParameterAcceptor(section)
    {
      add_parameter(
        "Element",
        element_name,
        "'hermite': slender, torsion-free, smooth, six unknowns per "
        "node. 'director': nine unknowns per node, with torsion, "
        "shear and strains of the section; where fibers are curved "
        "and free to turn it takes fewer iterations [-].",
        prm,
        Patterns::Selection("hermite|director"));
      add_parameter("Degree",
                    degree,
                    "Polynomial degree of 'director'. Inactive for 'hermite', "
                    "which is cubic [-].",
                    prm,
                    Patterns::Integer(1, 3));
      add_parameter(
        "Elements per fiber",
        elements_per_fiber,
        "Number of elements of every fiber of a weave. Inactive for "
        "centerlines from a file, which have an element length [-].",
        prm,
        Patterns::Integer(1));
      add_parameter("Axial modulus",
                    axial_modulus,
                    "Young's modulus along the fiber [MPa].",
                    prm,
                    Patterns::Double(1e-12));
      add_parameter(
        "Shear modulus",
        shear_modulus,
        "Shear modulus; 0: of an isotropic fiber, E / (2 (1 + nu)). "
        "Carbon and aramid are far softer. Where it is less than about a "
        "hundredth of the axial modulus few and thick fibers kink as they "
        "cross, and an equilibrium may not be found. Inactive for 'hermite' "
        "[MPa].",
        prm,
        Patterns::Double(0.));
      add_parameter("Poisson ratio",
                    poisson_ratio,
                    "Contraction of the section over axial strain [-].",
                    prm,
                    Patterns::Double(0., 0.49));
      add_parameter(
        "Axial stiffness",
        axial_stiffness,
        "E A of all fibers, in place of that of the circle; 0: of the "
        "circle [N].",
        prm,
        Patterns::Double(0.));
      add_parameter("Bending stiffness",
                    bending_stiffness,
                    "E I of all fibers, in place of that of the circle; 0: of "
                    "the circle [N mm^2].",
                    prm,
                    Patterns::Double(0.));
      add_parameter("Torsional stiffness",
                    torsional_stiffness,
                    "G J, in place of that of the circle; 0: of the circle. "
                    "Inactive for 'hermite' [N mm^2].",
                    prm,
                    Patterns::Double(0.));
      add_parameter("Shear stiffness",
                    shear_stiffness,
                    "k G A, in place of that of the circle; 0: of the "
                    "circle, with k = 1. "
                    "Inactive for 'hermite' [N].",
                    prm,
                    Patterns::Double(0.));
      add_parameter(
        "Section stiffness",
        section_stiffness,
        "S A, by which sections resist changes of their shape; 0: "
        "that of an isotropic fiber, S = E / (2 (1 + nu)), whatever "
        "the shear modulus. Soft sections flatten where a fiber "
        "is bent, and it kinks. Inactive for 'hermite' [N].",
        prm,
        Patterns::Double(0.));
    }



    std::unique_ptr<Beam::Element>
    FiberParameters::element() const
    {
      return Beam::make_element(element_name, degree);
    }



    Beam::Section
    FiberParameters::section(const double radius,
                             const double filament_radius) const
    {
      Beam::Section section = Beam::circular_section(
        radius,
        axial_modulus,
        shear_modulus > 0. ? shear_modulus
                           : axial_modulus / (2. * (1. + poisson_ratio)),
        poisson_ratio);
      if (filament_radius > 0.)
        {
          const double ratio = filament_radius / radius;
          section.bending *= ratio * ratio;
          section.torsion *= ratio * ratio;
          section.gradient *= ratio * ratio;
        }
      if (axial_stiffness > 0.)
        section.axial = axial_stiffness;
      if (bending_stiffness > 0.)
        section.bending = bending_stiffness;
      if (torsional_stiffness > 0.)
        section.torsion = torsional_stiffness;
      if (shear_stiffness > 0.)
        section.shear = shear_stiffness;
      if (section_stiffness > 0.)
        {
          section.gradient *= section_stiffness / section.thickness;
          section.thickness = section_stiffness;
        }
      return section;
    }
  } // namespace Simulation
} // namespace Heddle
