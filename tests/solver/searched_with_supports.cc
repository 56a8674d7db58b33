// A fiber is pushed against another one that it touches. What its ends
// still have to move by is little beside that, and does not keep the solver
// from looking where the energy stops falling: near where it begins. They go no
// deeper into each other on the way than where nothing is prescribed.
#include <heddle/contributions/fiber_contact.h>

#include "../contributions/scene.h"

#include <sstream>

constexpr double length = 10., radius = 0.15;

/** The deepest penetration on the way, in radii, if an end moves by @p motion.
 */
double
deepest(const std::string &element, const std::string &motion)
{
  Scene scene;
  scene.fibers.element_name       = element;
  scene.fibers.elements_per_fiber = 20;
  scene.fibers.axial_modulus      = 1e4;
  for (const std::string end : {"first end", "last end"})
    {
      auto &support        = scene.add_support();
      support.nodes.nodes  = end;
      support.nodes.fibers = "0";
      support.displacement = {{end == "last end" ? motion : "0", "0", "0"}};
    }
  scene.clamp("all", "1");
  auto &load        = scene.add_load();
  load.nodes.fibers = "0";
  load.nodes.nodes  = "all";
  load.force        = {{"0", "0", "-0.2*t"}};

  const Tensor<1, 3> begin({-0.5 * length, 0., 2. * radius}),
    along({length, 0., 0.}), below({0., -0.5 * length, 0.}),
    across({0., length, 0.});
  scene.build({straight_path(begin, begin + along, 21, radius),
               straight_path(below, below + across, 21, radius)});
  const Contact::ContactParameters contact;
  scene.contributions.push_back(
    std::make_shared<Contributions::FiberContact>(*scene.space, contact));
  const auto result = scene.solve(1.);

  std::istringstream words(scene.screen.str());
  std::string        word;
  double             largest = 0., value = 0.;
  while (words >> word)
    if (word == "penetration" && words >> value)
      largest = std::max(largest, value);
  deallog << element << ", an end moves by " << motion << ": converged "
          << result.converged << std::endl;
  return largest;
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  for (const std::string element : {"hermite", "director"})
    {
      const double still = deepest(element, "0");
      deallog << "  less than 0.05 R deep on the way: " << (still < 0.05)
              << std::endl;
      for (const std::string motion : {"1e-5*t", "-1e-5*t"})
        {
          const double moved = deepest(element, motion);
          deallog << "  no deeper on the way than without: "
                  << (moved < 1.1 * still) << std::endl;
        }
    }
}
