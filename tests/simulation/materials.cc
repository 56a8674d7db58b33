// Fibers are called by their sets, their yarns and their numbers, and each is
// of the one material that a parameter file gives to it. What is no fiber, or
// given to two materials, is said in one sentence.
#include <heddle/base/exceptions.h>
#include <heddle/simulation/fiber_parameters.h>

#include "../tests.h"

using namespace Heddle;

/** Two yarns of the warp and two of the weft, in turn, of two fibers each, and
 * a fiber by itself. */
std::vector<FiberName>
woven()
{
  std::vector<FiberName> fibers;
  for (unsigned int turn = 0; turn < 4; ++turn)
    for (unsigned int i = 0; i < 2; ++i)
      fibers.push_back(
        {turn % 2 == 0 ? "warp" : "weft", turn / 2 + (turn % 2 == 0 ? 0 : 2)});
  fibers.push_back({"", numbers::invalid_unsigned_int});
  return fibers;
}



/** Two yarns of no set. */
std::vector<FiberName>
strands()
{
  return {{"", 0}, {"", 0}, {"", 1}};
}



void
find(const std::vector<FiberName> &fibers, const std::string &words)
{
  deallog << '"' << words << "\":";
  try
    {
      for (const unsigned int f : FiberNames(fibers).find(words, "Here"))
        deallog << ' ' << f;
      deallog << std::endl;
    }
  catch (const InputError &error)
    {
      deallog << ' ' << error.what() << std::endl;
    }
}



/** Materials of these fibers, and the stiffness of a thick and a thin one. */
void
describe(const std::string &first, const std::string &second)
{
  constexpr double            radius = 0.01, filament_radius = 0.004;
  Simulation::FiberParameters parameters;
  parameters.material.axial_modulus = 1e5;
  for (const std::string number : {"1", "2"})
    parameters.materials.push_back(
      std::make_shared<Simulation::MaterialParameters>("/Fiber/Material " +
                                                       number));
  parameters.materials[0]->fibers                   = first;
  parameters.materials[0]->material.axial_modulus   = 2e5;
  parameters.materials[0]->material.shear_modulus   = 5e3;
  parameters.materials[0]->material.poisson_ratio   = 0.3;
  parameters.materials[1]->fibers                   = second;
  parameters.materials[1]->material.axial_stiffness = 7.;
  try
    {
      const auto numbers = parameters.materials_of(FiberNames(woven()));
      deallog << "materials:";
      for (const unsigned int number : numbers)
        deallog << ' ' << number;
      deallog << std::endl;
      for (const unsigned int number : {0, 1, 2})
        {
          const auto  &material = parameters.material_number(number);
          const auto   section  = material.section(radius);
          const auto   strand   = material.section(radius, filament_radius);
          const double area     = numbers::PI * radius * radius;
          deallog << number << ": E " << section.axial / area << ", of bending "
                  << section.bending / (area * radius * radius / 4.) << ", G "
                  << section.shear / area << ", nu " << section.poisson_ratio
                  << ", of a strand " << strand.axial / area << ", "
                  << strand.bending / section.bending << std::endl;
        }
    }
  catch (const InputError &error)
    {
      deallog << error.what() << std::endl;
    }
  parameters.materials.clear();
}



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  for (const std::string words : {"all",
                                  "warp",
                                  "warp 1",
                                  "weft 0",
                                  "yarn 3",
                                  "5",
                                  "warp 0, weft 1, 2",
                                  "8, 8, 0",
                                  "9",
                                  "wrap",
                                  "warp 2",
                                  "yarn 4",
                                  "none",
                                  "warp,, 2",
                                  ""})
    find(woven(), words);
  for (const std::string words : {"yarn 1", "warp"})
    find(strands(), words);
  find({{"", numbers::invalid_unsigned_int}}, "yarn 0");

  describe("weft", "warp 1, 8");
  describe("weft, 8", "0, 3");
  describe("all", "none");
  describe("weft", "");
}
