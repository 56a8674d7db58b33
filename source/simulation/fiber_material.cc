#include <heddle/simulation/fiber_material.h>

namespace Heddle
{
  namespace Simulation
  {
    void
    FiberMaterial::add_parameters(ParameterAcceptor &owner)
    {
      owner.add_parameter("Axial modulus",
                          axial_modulus,
                          "Young's modulus along the fiber [MPa].",
                          ParameterAcceptor::prm,
                          Patterns::Double(1e-12));
      owner.add_parameter(
        "Shear modulus",
        shear_modulus,
        "Shear modulus; 0: of an isotropic fiber, E / (2 (1 + nu)). "
        "Carbon and aramid are far softer. Where it is less than about a "
        "fortieth of the axial modulus few and thick fibers kink as they "
        "cross: searches are long, and an equilibrium may not be found. There "
        "give as many elements that none is bent by more than sqrt(8 G / E), "
        "for beyond that its ends spin for nothing. Inactive for 'hermite' "
        "[MPa].",
        ParameterAcceptor::prm,
        Patterns::Double(0.));
      owner.add_parameter("Poisson ratio",
                          poisson_ratio,
                          "Contraction of the section over axial strain [-].",
                          ParameterAcceptor::prm,
                          Patterns::Double(0., 0.49));
      owner.add_parameter(
        "Axial stiffness",
        axial_stiffness,
        "E A of each fiber, in place of that of the circle; 0: of the "
        "circle [N].",
        ParameterAcceptor::prm,
        Patterns::Double(0.));
      owner.add_parameter(
        "Bending stiffness",
        bending_stiffness,
        "E I of each fiber, in place of that of the circle; 0: of "
        "the circle [N mm^2].",
        ParameterAcceptor::prm,
        Patterns::Double(0.));
      owner.add_parameter(
        "Torsional stiffness",
        torsional_stiffness,
        "G J, in place of that of the circle; 0: of the circle. "
        "Inactive for 'hermite' [N mm^2].",
        ParameterAcceptor::prm,
        Patterns::Double(0.));
      owner.add_parameter("Shear stiffness",
                          shear_stiffness,
                          "k G A, in place of that of the circle; 0: of the "
                          "circle, with k = 1. "
                          "Inactive for 'hermite' [N].",
                          ParameterAcceptor::prm,
                          Patterns::Double(0.));
      owner.add_parameter(
        "Section stiffness",
        section_stiffness,
        "S A, by which sections resist changes of their shape; 0: "
        "that of an isotropic fiber, S = E / (2 (1 + nu)), whatever "
        "the shear modulus. Soft sections flatten where a fiber "
        "is bent, and it kinks. Inactive for 'hermite' [N].",
        ParameterAcceptor::prm,
        Patterns::Double(0.));
      owner.add_parameter(
        "Density",
        density,
        "Of the fibers, for what a fabric weighs: nothing else depends on "
        "it. 0: not known, or, in a weave, that of its yarns "
        "(Weave/Warp yarns/Density), which it must not contradict [g/cm^3].",
        ParameterAcceptor::prm,
        // Of osmium 22.6; in kg/m^3 they are a thousand times as large.
        Patterns::Double(0., 25.));
    }



    Beam::Section
    FiberMaterial::section(const double radius,
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



    MaterialParameters::MaterialParameters(const std::string &section_name)
      : ParameterAcceptor(section_name)
    {
      add_parameter("Fibers",
                    fibers,
                    "The fibers of this material, of which all entries are in "
                    "this section: nothing is taken from section Fiber, whose "
                    "material is that of all other fibers. A list as in "
                    "'Supports/Support 1/Fibers': names of sets ('weft'), of "
                    "their yarns ('warp 0'), of yarns ('yarn 3') and numbers "
                    "of fibers [-].");
      material.add_parameters(*this);
    }



    MaterialList
    declare_materials(const ParameterFile &file)
    {
      MaterialList       materials;
      const unsigned int n = file.count_sections("/Fiber", "Material");
      for (unsigned int i = 1; i <= n; ++i)
        materials.push_back(std::make_shared<MaterialParameters>(
          "/Fiber/Material " + std::to_string(i)));
      return materials;
    }
  } // namespace Simulation
} // namespace Heddle
