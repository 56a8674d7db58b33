// Where a fiber is shortened far beyond its buckling load and still nearly
// straight its tangent is not positive definite, and Newton's increment leads
// uphill, to the unstable state. Beside another fiber, which makes the solver
// look at the energy, it goes to the stable one: a half wave to the side to
// which a small load pushes, whose height follows from the shortening.
#include <heddle/contributions/fiber_contact.h>

#include "../contributions/scene.h"

constexpr double length = 10., radius = 0.15, shortening = 0.1;

void
examine(const std::string &element)
{
  Scene scene;
  scene.fibers.element_name       = element;
  scene.fibers.elements_per_fiber = 20;
  scene.fibers.axial_modulus      = 1e4;
  scene.newton.max_iterations     = 200;
  for (const std::string end : {"first end", "last end"})
    {
      auto &support        = scene.add_support();
      support.nodes.nodes  = end;
      support.nodes.fibers = "0";
      support.displacement = {
        {end == "last end" ? "-" + std::to_string(shortening) + "*t" : "0",
         "0",
         "0"}};
    }
  scene.clamp("all", "1");
  auto &load        = scene.add_load();
  load.nodes.fibers = "0";
  load.nodes.nodes  = "all";
  load.force        = {{"0", "1e-3", "0"}};

  const Tensor<1, 3> end({length, 0., 0.}), beside({0., 0., 2.02 * radius});
  scene.build({straight_path({}, end, 21, radius),
               straight_path(beside, beside + end, 21, radius)});
  const Contact::ContactParameters contact;
  scene.contributions.push_back(
    std::make_shared<Contributions::FiberContact>(*scene.space, contact));

  const auto   result = scene.solve(1.);
  const double height = scene.block(0, 10)[1];

  // A flat sine of height h is longer than its chord by (pi h)^2 / 4 l. The rod
  // keeps the strain at which it buckles.
  const double buckling = std::pow(0.5 * numbers::PI * radius / length, 2.);
  const double expected =
    2. / numbers::PI *
    std::sqrt((shortening - buckling * length) * (length - shortening));
  deallog << element << ": converged " << result.converged
          << ", height over that of a sine within 1 % "
          << (std::abs(height / expected - 1.) < 0.01) << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  examine("hermite");
  examine("director");
}
