#ifndef heddle_simulation_fiber_material_h
#define heddle_simulation_fiber_material_h

#include <heddle/base/parameter_file.h>
#include <heddle/beam/element.h>

#include <deal.II/base/parameter_acceptor.h>

#include <memory>
#include <string>
#include <vector>

namespace Heddle
{
  namespace Simulation
  {
    using namespace dealii;

    /** What fibers are made of, or how stiff they are. */
    struct FiberMaterial
    {
      /** Declare the entries in the section of @p owner. */
      void
      add_parameters(ParameterAcceptor &owner);

      /**
       * Constants of the section of a fiber of this radius [mm]. If it stands
       * for filaments of a smaller one, it bends and twists as they do side by
       * side: $(R / r)^2$ filaments have the area of the fiber, and the part
       * $(r / R)^2$ of its second moments.
       */
      Beam::Section
      section(const double radius, const double filament_radius = 0.) const;

      double axial_modulus       = 72400.;
      double shear_modulus       = 0.;
      double poisson_ratio       = 0.22;
      double axial_stiffness     = 0.;
      double bending_stiffness   = 0.;
      double torsional_stiffness = 0.;
      double shear_stiffness     = 0.;
      double section_stiffness   = 0.;
      double density             = 0.; /**< 0: not known [g/cm^3] */
    };

    /** A material of some fibers, in place of that of all others. */
    class MaterialParameters : public ParameterAcceptor
    {
    public:
      MaterialParameters(const std::string &section_name);

      std::string   fibers;
      FiberMaterial material;
    };

    using MaterialList = std::vector<std::shared_ptr<MaterialParameters>>;

    /** Return one object for each section *Fiber/Material N* of the file. */
    MaterialList
    declare_materials(const ParameterFile &file);
  } // namespace Simulation
} // namespace Heddle

#endif
