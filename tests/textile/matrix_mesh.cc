// The mesh finds each point of its cells and none elsewhere; its volume is that
// of the block, or what lies between the surfaces of the fabric.
#include <heddle/textile/matrix_mesh.h>

#include "../tests.h"
#include "woven_fabric.h"

#include <random>

using namespace Heddle::Textile;



/** The trilinear map of a cell, from its vertices. */
Point<3>
map_to_space(const MatrixMesh       &mesh,
             const MatrixMesh::Cell &cell,
             const Point<3>         &unit)
{
  Point<3> point;
  for (unsigned int v = 0; v < 8; ++v)
    {
      double weight = 1.;
      for (unsigned int d = 0; d < 3; ++d)
        weight *= (v >> d) & 1 ? unit[d] : 1. - unit[d];
      point += weight * mesh.vertices()[cell.vertices[v]];
    }
  return point;
}



void
check(const std::string &name, const MatrixMesh &mesh)
{
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> any(0., 1.);

  unsigned int n_points = 0, n_wrong = 0, n_hidden = 0, n_found_hidden = 0;
  double       error = 0., volume = 0.;
  for (unsigned int c = 0; c < mesh.cells().size(); ++c)
    {
      volume += mesh.volume(c);
      for (unsigned int i = 0; i < 20; ++i, ++n_points)
        {
          const Point<3> unit(any(random), any(random), any(random));
          const auto     place =
            mesh.locate(map_to_space(mesh, mesh.cells()[c], unit));
          n_wrong += place.cell == c ? 0 : 1;
          error = std::max(error, (place.unit - unit).norm());
        }
    }

  // Cells of the grid that are none of the mesh.
  std::vector<bool> is_kept(mesh.grid().n_cells(), false);
  for (const MatrixMesh::Cell &cell : mesh.cells())
    is_kept[cell.number] = true;
  for (unsigned int c = 0; c < is_kept.size(); ++c)
    if (!is_kept[c])
      {
        const Point<3> unit(any(random), any(random), any(random));
        ++n_hidden;
        n_found_hidden +=
          mesh.locate(mesh.grid().position(c, unit)).cell == no_cell ? 0 : 1;
      }

  unsigned int   n_found_outside = 0;
  const auto    &low             = mesh.grid().columns().low;
  const auto    &high            = mesh.grid().columns().high;
  const Point<2> middle(0.3 * low + 0.7 * high);
  for (const Point<3> &point : {Point<3>(low[0] - 1e-6, middle[1], 0.),
                                Point<3>(high[0] + 1e-6, middle[1], 0.),
                                Point<3>(middle[0], low[1] - 1e-6, 0.),
                                Point<3>(middle[0], high[1] + 1e-6, 0.),
                                Point<3>(middle[0], middle[1], 0.2),
                                Point<3>(middle[0], middle[1], -0.2)})
    n_found_outside += mesh.locate(point).cell == no_cell ? 0 : 1;

  deallog << name << ": " << mesh.cells().size() << " of "
          << mesh.grid().n_cells() << " cells, " << n_points << " points, "
          << n_wrong
          << " in a wrong cell, error below 1e-10: " << (error < 1e-10)
          << "; of " << n_hidden << " in cells left out " << n_found_hidden
          << " found, outside " << n_found_outside
          << "; volumes of the cells add up: "
          << (std::abs(volume / mesh.volume() - 1.) < 1e-12) << std::endl;
}



/** Integral of upper minus lower surface, by the Gauss rule that is exact. */
double
volume_between_surfaces(const LayeredGrid &grid)
{
  const double shift    = std::sqrt(1. / 12.);
  double       integral = 0.;
  for (unsigned int j = 0; j < grid.n_along()[1]; ++j)
    for (unsigned int i = 0; i < grid.n_along()[0]; ++i)
      for (const double xi : {0.5 - shift, 0.5 + shift})
        for (const double eta : {0.5 - shift, 0.5 + shift})
          {
            const Point<3> up = grid.position(
              grid.cell({{i, j, grid.n_along()[2] - 1}}), {xi, eta, 1.});
            const Point<3> down =
              grid.position(grid.cell({{i, j, 0}}), {xi, eta, 0.});
            integral += 0.25 * grid.columns().size(0) * grid.columns().size(1) *
                        (up[2] - down[2]);
          }
  return integral;
}



int
main()
{
  initlog();
  const WovenFabric     plain("plain"), wide("twill 2/2", 3, 3);
  MatrixMeshDescription description;
  check("plain", MatrixMesh(description, plain.fibers, plain.nodes));
  check("wide twill", MatrixMesh(description, wide.fibers, wide.nodes));

  description.leave_out = false;
  const MatrixMesh full(description, plain.fibers, plain.nodes);
  check("full", full);
  deallog << "volume over that between the surfaces: "
          << full.volume() / volume_between_surfaces(full.grid()) << std::endl;

  description.shape       = MatrixShape::block;
  description.n_cells     = {{7, 5, 3}};
  description.low_corner  = {-0.1, -0.2, -0.05};
  description.high_corner = {0.2, 0.2, 0.03};
  const MatrixMesh block(description, plain.fibers, plain.nodes);
  check("block", block);
  deallog << "volume over 0.3 x 0.4 x 0.08: "
          << block.volume() / (0.3 * 0.4 * 0.08) << std::endl;
}
