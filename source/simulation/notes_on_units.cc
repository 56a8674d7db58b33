#include <heddle/base/number_text.h>
#include <heddle/simulation/notes_on_units.h>

namespace Heddle
{
  namespace Simulation
  {
    namespace
    {
      /** What there is of a quantity, with room to either side. */
      struct Usual
      {
        double low, high;

        bool
        has(const double value) const
        {
          return value >= low && value <= high;
        }
      };

      /** Of soft polymers and of the stiffest carbon, along a fiber; less have
       * rubber and its like alone [MPa]. */
      constexpr Usual fiber_moduli = {500., 2e6};

      /** Of fibers that electricity spins, and of rods [mm]. */
      constexpr Usual fiber_radii = {5e-5, 1.};

      /** Of gels and of ceramics [MPa]. */
      constexpr Usual matrix_moduli = {1e-3, 1e6};



      std::string
      note_on_fiber(const System::Fiber &fiber)
      {
        const double modulus =
          fiber.section.axial / (numbers::PI * fiber.radius * fiber.radius);
        if (!fiber_moduli.has(modulus))
          return "fibers have a modulus of " + number_text(modulus, 3) +
                 " MPa along them (Fiber/Axial modulus): drawn polymers have "
                 "1000 to 200000, glass 72000, carbon up to 900000; see "
                 "whether it is in MPa, and radii in mm";
        if (!fiber_radii.has(fiber.radius))
          return "fibers have a radius of " + number_text(fiber.radius, 3) +
                 " mm: filaments of glass and carbon have 0.0025 to 0.012; see "
                 "whether lengths are in mm";
        return "";
      }
    } // namespace



    std::vector<std::string>
    notes_on_units(const Scene &scene, const Parameters &parameters)
    {
      std::vector<std::string> notes;
      if (!scene.is_fabric())
        return notes;
      const System::FiberSpace &space = scene.space();
      std::string               of_fibers;
      for (unsigned int f = 0; f < space.n_fibers() && of_fibers.empty(); ++f)
        of_fibers = note_on_fiber(space.fiber(f));
      if (!of_fibers.empty())
        notes.push_back(of_fibers);
      const double modulus = parameters.matrix.material.youngs_modulus;
      if (parameters.matrix.enabled && !matrix_moduli.has(modulus))
        notes.push_back("Matrix/Youngs modulus is " + number_text(modulus, 3) +
                        " MPa: epoxy has 3000, rubber 1 to 10; see whether it "
                        "is in MPa");
      return notes;
    }
  } // namespace Simulation
} // namespace Heddle
