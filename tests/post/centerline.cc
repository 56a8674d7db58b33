// Sampled between its nodes, the centerline of a fiber that lies on a circle
// stays on the circle and its points equally far from each other, for both
// elements, and rank 0 gets those of all ranks in their order.
#include <heddle/post/centerline.h>
#include <heddle/simulation/fiber_placement.h>

#include <deal.II/base/numbers.h>

#include "../tests.h"

#include <algorithm>

using namespace Heddle;



/** A quarter of a circle of radius @p radius about the z-axis. */
Textile::FiberPath
quarter(const double radius, const unsigned int n_elements)
{
  Textile::FiberPath path;
  for (unsigned int i = 0; i <= n_elements; ++i)
    {
      const double angle = 0.5 * numbers::PI * i / n_elements;
      path.points.push_back(
        Tensor<1, 3>({radius * std::cos(angle), radius * std::sin(angle), 0.}));
    }
  path.reference_length = 0.5 * numbers::PI * radius;
  path.radius           = 0.1;
  return path;
}



void
print(const std::string &element)
{
  Simulation::FiberParameters parameters("/Fiber " + element);
  parameters.element_name                     = element;
  parameters.elements_per_fiber               = 16;
  const std::vector<Textile::FiberPath> paths = {
    quarter(1., 16), quarter(2., 16), quarter(3., 16)};
  const auto space = Simulation::make_space(paths, parameters, MPI_COMM_WORLD);
  System::State state(*space);
  const auto    blocks = Simulation::place_on_paths(*space, paths);
  std::copy(
    blocks.begin(), blocks.end(), state.fiber(space->owned_fibers().first));

  for (const Polyline &line : Post::gather_centerlines(state, 5))
    {
      double off = 0., uneven = 0.;
      for (unsigned int i = 1; i < line.size(); ++i)
        {
          const double radius = line[0].norm();
          const double chord  = 0.5 * numbers::PI * radius / (line.size() - 1);
          off    = std::max(off, std::abs(line[i].norm() / radius - 1.));
          uneven = std::max(
            uneven, std::abs((line[i] - line[i - 1]).norm() / chord - 1.));
        }
      deallog << element << ": " << line.size() << " points, from "
              << line.front().norm() << ", off the circle by "
              << (off < 1e-3 ? "less than 1e-3" : "more") << ", uneven by "
              << (uneven < 2e-2 ? "less than 2e-2" : "more") << std::endl;
    }
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  print("hermite");
  print("director");
}
