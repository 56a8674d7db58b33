// Sampled between its nodes, the centerline of a fiber that lies on a circle
// stays on the circle, for both elements, and rank 0 gets those of all ranks in
// their order.
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

  for (const Post::Polyline &line : Post::gather_centerlines(state, 5))
    {
      double smallest = 1e300, largest = 0.;
      for (const Tensor<1, 3> &point : line)
        {
          smallest = std::min(smallest, point.norm());
          largest  = std::max(largest, point.norm());
        }
      deallog << element << ": " << line.size() << " points, from "
              << line.front().norm() << ", distance from the axis uneven by "
              << (largest - smallest < 1e-3 * largest ? "less than 1e-3"
                                                      : "more")
              << std::endl;
    }
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  print("hermite");
  print("director");
}
