// Two nodes that changed places turn the element between them back on itself:
// that is objected to, as is any compression by more than 0.3. A strain of 0.8
// is none, nor is a fiber that is bent to a ring of five times its radius.
#include "scene.h"

#include <functional>

/** Where a particle of the straight fiber, 8 mm long, goes. */
using Motion = std::function<Tensor<1, 3>(const double)>;

void
examine(const std::string &element,
        const std::string &name,
        const Motion      &motion)
{
  Scene scene;
  scene.fibers.element_name = element;
  auto path = straight_path({}, Tensor<1, 3>({8., 0., 0.}), 9, 0.25);
  for (unsigned int i = 0; i < path.points.size(); ++i)
    path.points[i] = motion(i);
  scene.build({straight_path({}, Tensor<1, 3>({8., 0., 0.}), 9, 0.25)});
  scene.state->set(Simulation::place_on_paths(*scene.space, {path}));
  const std::string objection =
    scene.contributions.front()->objection(*scene.state);
  deallog << element << ", " << name << ": "
          << (objection.empty() ? "nothing" : objection) << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  for (const std::string element : {"hermite", "director"})
    {
      const auto along = [](const double x) {
        return Tensor<1, 3>({x, 0., 0.});
      };
      examine(element, "straight", along);
      examine(element, "bent to a ring", [](const double x) {
        const double angle = 2. * numbers::PI * x / 8.;
        return 8. / (2. * numbers::PI) *
               Tensor<1, 3>({std::sin(angle), 1. - std::cos(angle), 0.});
      });
      examine(element, "compressed by 0.2", [&](const double x) {
        return along(0.8 * x);
      });
      examine(element, "stretched by 0 to 0.64", [&](const double x) {
        return along(x + 0.04 * x * x);
      });
      examine(element, "compressed by 0 to 0.48", [&](const double x) {
        return along(x - 0.03 * x * x);
      });
      examine(element, "two nodes changed places", [&](const double x) {
        return along(x == 3. || x == 4. ? 7. - x : x);
      });
    }
}
