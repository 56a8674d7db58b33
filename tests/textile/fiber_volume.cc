// The volume of fibers in the cells of a matrix: a cylinder along an edge of
// cells has a quarter of its section in each of four cells as long as these are
// wider than it, and fills cells that are finer. What sticks out does not
// count.
#include <heddle/textile/fiber_volume.h>

#include "../tests.h"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace Heddle::Textile;

constexpr double radius = 0.3;



void
check(const unsigned int n, const Tensor<1, 3> &begin, const Tensor<1, 3> &end)
{
  const std::vector<FiberAxis> fibers = {{{begin, end}, radius, no_id}};
  MatrixMeshDescription        description;
  description.shape       = MatrixShape::block;
  description.n_cells     = {{n, n, n}};
  description.low_corner  = {-1., -1., -1.};
  description.high_corner = {1., 1., 1.};
  description.leave_out   = false;
  const MatrixMesh          mesh(description, fibers, fibers[0].points);
  const std::vector<double> volumes = fiber_volumes(mesh, fibers);

  // Parts of cells whose middle lies deep inside and far outside of the fiber.
  const Tensor<1, 3> along  = (end - begin) / (end - begin).norm();
  const double       size   = 2. / n;
  double             inside = 0., outside = 0.;
  unsigned int       n_inside = 0;
  for (unsigned int c = 0; c < volumes.size(); ++c)
    {
      const Tensor<1, 3> middle(
        mesh.grid().position(mesh.cells()[c].number, Point<3>(0.5, 0.5, 0.5)));
      const double distance =
        cross_product_3d(along, middle - begin).norm() / radius;
      const double half_diagonal = std::sqrt(0.75) * size / radius;
      const double part          = volumes[c] / mesh.volume(c);
      if (distance + half_diagonal < 1.)
        {
          ++n_inside;
          inside = std::max(inside, std::abs(part - 1.));
        }
      if (distance - half_diagonal > 1.)
        outside = std::max(outside, part);
    }
  deallog << n << " cells along each side: in all over pi R^2 L "
          << std::accumulate(volumes.begin(), volumes.end(), 0.) /
               (numbers::PI * radius * radius * 2.)
          << ", largest part "
          << *std::max_element(volumes.begin(), volumes.end()) /
               (size * size * size)
          << "; of " << n_inside
          << " cells inside within 0.15 of full: " << (inside < 0.15)
          << ", outside " << outside << std::endl;
}



int
main()
{
  initlog();
  const Tensor<1, 3> low({-1., 0., 0.}), high({1., 0., 0.});
  deallog << "A quarter of the section over that of a cell, 2 cells: "
          << numbers::PI * radius * radius / 4.
          << ", 4 cells: " << numbers::PI * radius * radius << std::endl;
  for (const unsigned int n : {2, 4, 8, 16, 32})
    check(n, low, high);
  deallog << "Askew, out of the block at both ends: its length over 2 is "
          << std::sqrt(1. + 0.1 * 0.1 + 0.05 * 0.05) << std::endl;
  for (const unsigned int n : {4, 16})
    check(n, Tensor<1, 3>({-1.5, -0.1, 0.05}), Tensor<1, 3>({1.5, 0.2, -0.1}));
  deallog << "Half of it above the block" << std::endl;
  for (const unsigned int n : {4, 16})
    check(n, Tensor<1, 3>({-1., 0., 1.}), Tensor<1, 3>({1., 0., 1.}));
}
