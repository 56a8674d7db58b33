// The sharpest bend of three fibers on waves, in whose vertices are radii of
// 1, 2 and 0.5 mm: radius of the fiber over 0.5 mm, found in the vertex
// of the last one, with the order that the slopes in the nodes have. Bent to
// its own radius a fiber has a kink.
#include <heddle/post/bend.h>
#include <heddle/simulation/fiber_placement.h>

#include "../tests.h"

using namespace Heddle;



/** One wave of a cosine, with @p radius in the vertex. */
Textile::FiberPath
wave(const double       radius,
     const unsigned int n_elements,
     const double       radius_of_fiber)
{
  Textile::FiberPath path;
  for (unsigned int i = 0; i <= n_elements; ++i)
    {
      const double x = (2. * i / n_elements - 1.) * radius;
      path.points.push_back(
        Tensor<1, 3>({x, -radius * std::cos(x / radius), radius}));
    }
  path.reference_length = 2. * radius;
  path.radius           = radius_of_fiber;
  return path;
}



Post::Bend
sharpest(const std::string &element,
         const unsigned int n_elements,
         const double       radius_of_fiber)
{
  Simulation::FiberParameters parameters("/Fiber " + element);
  parameters.element_name                     = element;
  parameters.elements_per_fiber               = n_elements;
  const std::vector<Textile::FiberPath> paths = {
    wave(1., n_elements, radius_of_fiber),
    wave(2., n_elements, radius_of_fiber),
    wave(0.5, n_elements, radius_of_fiber)};
  const auto space = Simulation::make_space(paths, parameters, MPI_COMM_WORLD);
  System::State state(*space);
  const auto    blocks = Simulation::place_on_paths(*space, paths);
  std::copy(
    blocks.begin(), blocks.end(), state.fiber(space->owned_fibers().first));
  return Post::sharpest_bend(state);
}



void
print(const std::string &element)
{
  std::vector<double> errors;
  for (const unsigned int n_elements : {8, 16, 32, 64})
    {
      const Post::Bend bend = sharpest(element, n_elements, 0.1);
      errors.push_back(std::abs(bend.ratio / 0.2 - 1.));
      deallog << element << ", " << n_elements << " elements: fiber "
              << bend.fiber << ", error " << errors.back();
      if (errors.size() > 1)
        deallog << ", order "
                << std::log2(errors[errors.size() - 2] / errors.back());
      deallog << ", a kink: " << bend.is_a_kink() << std::endl;
    }
  const Post::Bend bend = sharpest(element, 64, 0.55);
  deallog << "Thicker: " << bend.in_words() << ", a kink: " << bend.is_a_kink()
          << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  print("hermite");
  print("director");
}
