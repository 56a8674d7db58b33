// Contact forces turn with the fibers, do not depend on the order of the fibers
// nor on how often contact was searched, and are the same on all ranks.
#include "../contact/contact_scene.h"
#include "../tests.h"

constexpr unsigned int n_fibers    = 8;
constexpr unsigned int n_intervals = 10;

/** A loose bundle of wavy fibers, every third of them running across. */
std::vector<Path>
bundle()
{
  RandomNumbers     random(3);
  std::vector<Path> paths;
  for (unsigned int f = 0; f < n_fibers; ++f)
    {
      const double       y = 1.9 * (f % 3);
      const double       z = 3.8 * (f / 3) + (f % 3 == 2 ? 1.9 : 0.);
      const Tensor<1, 3> begin =
        f % 3 == 2 ? Tensor<1, 3>({0., -20., z}) : Tensor<1, 3>({-20., y, z});
      const Tensor<1, 3> along =
        f % 3 == 2 ? Tensor<1, 3>({0., 1., 0.})
                   : Tensor<1, 3>({f % 2 == 0 ? 1. : -1., 0., 0.});
      paths.push_back(wavy_line(
        f % 3 == 1 ? begin + 40. * Tensor<1, 3>({f % 2 == 0 ? 0. : 1., 0., 0.})
                   : begin,
        along,
        40.,
        0.3,
        random));
    }
  return paths;
}



/** Forces on the blocks of all fibers, on every rank. */
std::vector<Tensor<1, 3>>
all_forces(ContactScene &scene, const bool search)
{
  const std::vector<Tensor<1, 3>> &own = scene.forces(search);
  std::vector<double>              values(scene.space.n_dofs(), 0.);
  for (unsigned int b = 0; b < own.size(); ++b)
    for (unsigned int d = 0; d < 3; ++d)
      values[3 * (scene.space.owned_blocks().first + b) + d] = own[b][d];
  std::vector<double> sums(values.size());
  Utilities::MPI::sum(values, MPI_COMM_WORLD, sums);
  std::vector<Tensor<1, 3>> result(scene.space.n_blocks());
  for (unsigned int i = 0; i < sums.size(); ++i)
    result[i / 3][i % 3] = sums[i];
  return result;
}



double
difference(const std::vector<Tensor<1, 3>> &a,
           const std::vector<Tensor<1, 3>> &b)
{
  double largest = 0., size = 0.;
  for (unsigned int i = 0; i < a.size(); ++i)
    {
      largest = std::max(largest, (a[i] - b[i]).norm());
      size    = std::max(size, a[i].norm());
    }
  return largest / size;
}



int
main(int argc, char **argv)
{
  MPITest                         test(argc, argv);
  const std::vector<unsigned int> intervals(n_fibers, n_intervals);
  std::vector<Path>               paths = bundle();
  ContactScene                    scene(paths, intervals);
  const auto                      forces = all_forces(scene, true);

  double sum = 0.;
  for (const auto &force : forces)
    sum += force.norm();
  const double energy = scene.energy();
  deallog << std::setprecision(3) << "sum of forces " << sum << ", energy "
          << energy << std::endl;

  double largest = 0.;
  for (unsigned int n = 0; n < 10; ++n)
    largest = std::max(largest, difference(forces, all_forces(scene, true)));
  deallog << "ten searches: " << (largest < 1e-12 ? "the same" : "DIFFERENT")
          << std::endl;

  const Tensor<1, 3> axis({0.48, 0.6, 0.64});
  const Tensor<2, 3> turn = rotation(axis, 1.1);
  ContactScene       moved(paths, intervals);
  for (unsigned int f = 0; f < n_fibers; ++f)
    if (moved.space.owns(f))
      for (unsigned int b = 0; b < moved.space.n_blocks(f); ++b)
        moved.state.fiber(f)[b] =
          turn * moved.state.fiber(f)[b] +
          (b % 2 == 0 ? 1. : 0.) * Tensor<1, 3>({5., -7., 11.});
  auto turned_forces = all_forces(moved, true);
  for (auto &force : turned_forces)
    force = transpose(turn) * force;
  largest = difference(forces, turned_forces);
  deallog << "rigid motion: " << (largest < 1e-7 ? "the same" : "DIFFERENT")
          << std::endl;

  ContactScene reversed(std::vector<Path>(paths.rbegin(), paths.rend()),
                        intervals);
  const auto   from_last = all_forces(reversed, true);
  auto         in_order  = forces;
  const auto   n         = scene.space.n_blocks(0);
  for (unsigned int f = 0; f < n_fibers; ++f)
    for (unsigned int b = 0; b < n; ++b)
      in_order[f * n + b] = from_last[(n_fibers - 1 - f) * n + b];
  largest = difference(forces, in_order);
  deallog << "order of fibers: " << (largest < 1e-10 ? "the same" : "DIFFERENT")
          << std::endl;
}
