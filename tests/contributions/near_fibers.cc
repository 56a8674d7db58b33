// Pieces of foreign fibers that a rank holds: every interval that comes near an
// own fiber is among them, by distances between many points; the centerline in
// between is that of the whole fiber; and they are not all that there is.
#include <heddle/base/choice.h>
#include <heddle/contributions/near_fibers.h>

#include "../tests.h"

#include <random>

using namespace Heddle;

constexpr unsigned int n_fibers = 24, n_elements = 24, n_samples = 8;
constexpr double       margin = 0.25;



/** Wavy fibers along x and along y by turns, more or less. */
std::vector<Tensor<1, 3>>
random_blocks(const System::FiberSpace &space, const unsigned int f)
{
  std::mt19937                           generator(f);
  std::uniform_real_distribution<double> random(-1., 1.);
  const Tensor<1, 3>                     begin(
    {5. * random(generator), 5. * random(generator), 0.});
  Tensor<1, 3> along({10., 2. * random(generator), random(generator)});
  if (f % 2 == 1)
    std::swap(along[0], along[1]);
  const double phase = 3. * random(generator);

  const unsigned int        n = space.n_blocks_per_node();
  std::vector<Tensor<1, 3>> blocks(space.n_blocks(f));
  for (unsigned int i = 0; i < space.fiber(f).n_nodes; ++i)
    {
      const double t = double(i) / (space.fiber(f).n_nodes - 1) - 0.5;
      blocks[n * i]  = begin + t * along;
      blocks[n * i][2] += std::sin(phase + 6. * t);
      for (unsigned int b = 1; b < n; ++b)
        for (unsigned int d = 0; d < 3; ++d)
          blocks[n * i + b][d] = random(generator);
    }
  return blocks;
}



std::unique_ptr<System::FiberSpace>
make_space(const std::string &element, const unsigned int degree)
{
  System::FiberSpace::Description fiber = {};
  fiber.element_lengths.assign(n_elements, 10. / n_elements);
  fiber.radius = 0.1;
  fiber.section =
    Beam::circular_section(0.1, /*axial=*/1., /*shear=*/0.4, /*poisson=*/0.25);
  return std::make_unique<System::FiberSpace>(
    MPI_COMM_WORLD,
    Beam::make_element(choice<Beam::ElementKind>(element), degree),
    std::vector<System::FiberSpace::Description>(n_fibers, fiber));
}



std::vector<System::GhostFiber>
all_foreign(const System::FiberSpace &space)
{
  std::vector<System::GhostFiber> all;
  for (unsigned int f = 0; f < n_fibers; ++f)
    if (!space.owns(f))
      all.push_back({f, space.all_nodes(f)});
  return all;
}



/** Points of the cubic between knots @p i and i + 1. */
std::vector<Tensor<1, 3>>
sample(const Contact::Curve &curve, const unsigned int i)
{
  std::vector<Tensor<1, 3>> points;
  for (unsigned int k = 0; k <= n_samples; ++k)
    {
      const double t        = double(k) / n_samples;
      unsigned int interval = i;
      points.push_back(curve
                         .evaluate((1. - t) * curve.arc_lengths[i] +
                                     t * curve.arc_lengths[i + 1],
                                   interval)
                         .position);
    }
  return points;
}



double
distance(const std::vector<Tensor<1, 3>> &some,
         const std::vector<Tensor<1, 3>> &others)
{
  double least = 1e300;
  for (const Tensor<1, 3> &x : some)
    for (const Tensor<1, 3> &y : others)
      least = std::min(least, (x - y).norm());
  return least;
}



/** Whether the interval @p i of fiber @p f comes near an own fiber. */
bool
is_near(const System::FiberSpace         &space,
        const Contributions::Centerlines &lines,
        const unsigned int                f,
        const unsigned int                i)
{
  const auto points = sample(lines.curve(f), i);
  const auto owned  = space.owned_fibers();
  for (unsigned int g = owned.first; g < owned.second; ++g)
    for (unsigned int j = 0; j + 1 < space.fiber(g).n_nodes; ++j)
      if (distance(points, sample(lines.curve(g), j)) < 2. * margin)
        return true;
  return false;
}



void
check(const std::string &element, const unsigned int degree)
{
  const auto    space = make_space(element, degree);
  System::State whole(*space), held(*space);
  const auto    owned = space->owned_fibers();
  for (unsigned int f = owned.first; f < owned.second; ++f)
    {
      const auto blocks = random_blocks(*space, f);
      std::copy(blocks.begin(), blocks.end(), whole.fiber(f));
      std::copy(blocks.begin(), blocks.end(), held.fiber(f));
    }
  whole.set_ghost_fibers(all_foreign(*space));
  Contributions::Centerlines lines(*space), held_lines(*space);
  held_lines.set(held, held.current());
  const auto near = Contributions::find_near_fibers(*space, held_lines, margin);
  held.set_ghost_fibers(near);
  lines.set(whole, whole.current());
  held_lines.set(held, held.current());

  unsigned int n_near = 0, n_missing = 0;
  double       difference = 0.;
  for (unsigned int f = 0; f < n_fibers; ++f)
    for (unsigned int i = 0; i + 1 < space->fiber(f).n_nodes; ++i)
      {
        const auto knots = held_lines.curve(f).known;
        const bool known = i >= knots.first && i + 1 < knots.second;
        if (!space->owns(f) && is_near(*space, lines, f, i))
          {
            ++n_near;
            n_missing += known ? 0 : 1;
          }
        if (known)
          difference = std::max(
            difference,
            (sample(lines.curve(f), i)[3] - sample(held_lines.curve(f), i)[3])
              .norm());
      }
  const bool longer =
    !near.empty() && Contributions::holds(held, near) &&
    !Contributions::holds(held, Contributions::lengthened(*space, near, 1));
  deallog << element << " " << degree
          << ": intervals near: " << Utilities::MPI::sum(n_near, MPI_COMM_WORLD)
          << ", missing: " << Utilities::MPI::sum(n_missing, MPI_COMM_WORLD)
          << ", centerlines differ by "
          << Utilities::MPI::max(difference, MPI_COMM_WORLD)
          << ", ranks that hold less than all: "
          << Utilities::MPI::sum(held.n_local_blocks() < space->n_blocks() ? 1
                                                                           : 0,
                                 MPI_COMM_WORLD)
          << ", and would hold more: "
          << Utilities::MPI::sum(longer ? 1 : 0, MPI_COMM_WORLD) << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  check("hermite", 3);
  for (const unsigned int degree : {1, 2, 3})
    check("director", degree);
}
