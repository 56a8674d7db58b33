// The cells of a matrix: deal.II makes a triangulation of them, loose ones are
// dropped, their parts of the fibers add up, and make a ply.
#include <heddle/textile/fiber_volume.h>
#include <heddle/textile/kept_cells.h>
#include <heddle/textile/matrix_mesh.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include "../tests.h"
#include "woven_fabric.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

using namespace Heddle::Textile;

/** Whether the middle of a face lies where its id says. */
bool
lies_at(const MatrixMesh &mesh, const Point<3> &middle, const unsigned int id)
{
  const auto                 &columns  = mesh.grid().columns();
  const auto                  surface  = mesh.grid().locate(middle);
  const std::array<double, 6> distance = {
    {middle[0] - columns.low[0],
     middle[0] - columns.high[0],
     middle[1] - columns.low[1],
     middle[1] - columns.high[1],
     mesh.grid().index_of_cell(surface.cell)[2] + surface.unit[2],
     mesh.grid().index_of_cell(surface.cell)[2] + surface.unit[2] -
       mesh.grid().n_along()[2]}};
  for (unsigned int side = 0; side < 6; ++side)
    if ((std::abs(distance[side]) < 1e-9) != (side == id))
      return false;
  return true;
}



void
triangulate(const std::string &pattern, const bool leave_out)
{
  const WovenFabric     fabric(pattern, 4, 2);
  MatrixMeshDescription description;
  description.leave_out = leave_out;
  // Of the default, which are 43 x 43 x 11, Debug has more than it needs.
  description.n_cells = {{28, 28, 11}};
  const MatrixMesh mesh(description, fabric.fibers, fabric.nodes);

  std::vector<CellData<3>> cells;
  for (const MatrixMesh::Cell &cell : mesh.cells())
    {
      cells.emplace_back();
      for (unsigned int v = 0; v < 8; ++v)
        cells.back().vertices[v] = cell.vertices[v];
    }
  // A check of distorted cells is a part of it.
  Triangulation<3> triangulation(Triangulation<3>::none, true);
  try
    {
      triangulation.create_triangulation(mesh.vertices(), cells, SubCellData());
    }
  catch (const Triangulation<3>::DistortedCellList &list)
    {
      deallog << list.distorted_cells.size() << " distorted cells" << std::endl;
      return;
    }

  std::vector<std::array<int, 6>> ids(cells.size(), {{-1, -1, -1, -1, -1, -1}});
  for (const MatrixMesh::BoundaryFace &face : mesh.boundary())
    ids[face.cell][face.face] = face.side;
  std::array<unsigned int, 7> n_faces{};
  unsigned int                n_wrong = 0, n_misplaced = 0;
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const unsigned int face : cell->face_indices())
      {
        const int id = ids[cell->active_cell_index()][face];
        n_wrong += cell->at_boundary(face) == (id >= 0) ? 0 : 1;
        if (id >= 0)
          {
            ++n_faces[id];
            n_misplaced +=
              lies_at(mesh, cell->face(face)->center(), id) ? 0 : 1;
          }
      }
  deallog << pattern << ": " << triangulation.n_active_cells() << " of "
          << mesh.grid().n_cells() << " cells, all vertices used "
          << (triangulation.n_used_vertices() == mesh.vertices().size())
          << ", volume over that of the mesh "
          << GridTools::volume(triangulation) / mesh.volume()
          << ", faces by their ids";
  for (const unsigned int n : n_faces)
    deallog << " " << n;
  deallog << ", wrong " << n_wrong << ", misplaced " << n_misplaced
          << std::endl;
}



/**
 * deal.II makes a triangulation of the mesh without complaints: no distorted
 * cells, the volume of the mesh, and the promised ids at all sides.
 */
void
triangulations()
{
  triangulate("plain", true);
  triangulate("twill 2/2", true);
  triangulate("twill 2/2", false);
}



/** A grid of n^3 unit cells. */
LayeredGrid
cube(const unsigned int n)
{
  ColumnGrid columns;
  columns.high      = {double(n), double(n)};
  columns.n_columns = {{n, n}};
  return LayeredGrid(columns,
                     std::vector<double>(columns.n_corners(), 0.),
                     std::vector<double>(columns.n_corners(), n),
                     n);
}



void
drop(const std::string                     &name,
     const std::vector<Tensor<1, 3>>       &nodes,
     const std::vector<LayeredGrid::Index> &cells)
{
  const LayeredGrid grid = cube(5);
  KeptCells         kept(grid.n_cells(), false);
  for (const LayeredGrid::Index &index : cells)
    kept[grid.cell(index)] = true;
  const unsigned int n_before = connected_components(grid, kept).n_components;
  const DroppedCells dropped  = drop_loose_components(grid, nodes, kept);
  deallog << name << ": " << n_before << " components, dropped "
          << dropped.n_components << " of " << dropped.n_cells
          << " cells in all, left "
          << std::count(kept.begin(), kept.end(), true) << " cells in "
          << connected_components(grid, kept).n_components << std::endl;
}



/**
 * Cells are of one component if faces connect them; islands that no fiber holds
 * are dropped, those at a side or with three nodes off a line are not.
 */
void
loose_cells()
{
  const LayeredGrid::Index side = {{0, 2, 2}}, middle = {{2, 2, 2}},
                           top = {{2, 2, 3}}, diagonal = {{3, 3, 2}},
                           ceiling = {{1, 3, 4}};
  const Tensor<1, 3>              a({2.1, 2.1, 2.1}), b({2.5, 2.5, 2.5});
  const Tensor<1, 3>              c({2.9, 2.9, 2.9}), off({2.3, 2.9, 2.5});
  const std::vector<Tensor<1, 3>> line = {a, b, c}, three = {a, b, off};

  drop("nothing", {}, {});
  drop("at a side", {}, {side});
  drop("island", {}, {side, middle});
  drop("two cells", {}, {side, middle, top});
  drop("by an edge only", {}, {side, middle, diagonal});
  drop("below the surface only", {}, {side, ceiling});
  drop("two nodes", {a, off}, {side, middle});
  drop("three on a line", line, {side, middle});
  drop("three nodes", three, {side, middle});
  drop("one of two islands", three, {side, middle, diagonal});
  drop("nodes elsewhere", three, {side, diagonal});
}



constexpr double thick = 0.3, thin = 0.01;



void
cut(const unsigned int  n,
    const Tensor<1, 3> &begin,
    const Tensor<1, 3> &end,
    const double        radius = thick)
{
  const std::vector<FiberAxis> fibers = {{{begin, end}, radius, no_id}};
  MatrixMeshDescription        description;
  description.shape       = MatrixShape::block;
  description.n_cells     = {{n, n, n}};
  description.low_corner  = {-1., -1., -1.};
  description.high_corner = {1., 1., 1.};
  description.leave_out   = false;
  const MatrixMesh          mesh(description, fibers, fibers[0].points);
  const std::vector<double> volumes = fiber_volumes(mesh, fibers).in_cells;

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



/**
 * The volume of fibers in the cells of a matrix: a cylinder along an edge of
 * cells has a quarter of its section in each of four cells as long as these are
 * wider than it, and fills cells that are finer. What sticks out does not
 * count.
 */
void
volumes_of_fibers()
{
  const Tensor<1, 3> low({-1., 0., 0.}), high({1., 0., 0.});
  deallog << "A quarter of the section over that of a cell, 2 cells: "
          << numbers::PI * thick * thick / 4.
          << ", 4 cells: " << numbers::PI * thick * thick << std::endl;
  for (const unsigned int n : {2, 4, 8, 16, 32})
    cut(n, low, high);
  deallog << "Askew, out of the block at both ends: its length over 2 is "
          << std::sqrt(1. + 0.1 * 0.1 + 0.05 * 0.05) << std::endl;
  for (const unsigned int n : {4, 16})
    cut(n, Tensor<1, 3>({-1.5, -0.1, 0.05}), Tensor<1, 3>({1.5, 0.2, -0.1}));
  deallog << "Half of it above the block" << std::endl;
  for (const unsigned int n : {4, 16})
    cut(n, Tensor<1, 3>({-1., 0., 1.}), Tensor<1, 3>({1., 0., 1.}));
  deallog << "Thin, on a face, and on an edge" << std::endl;
  for (const double y : {0.3, 1.})
    cut(2, Tensor<1, 3>({-1., y, 1.}), Tensor<1, 3>({1., y, 1.}), thin);
}



/**
 * A ply has its thickness and its fibers whether or not cells are left out of
 * the mesh: those of all of them, and of the fibers between the sides.
 */
void
sizes_of_a_ply()
{
  const WovenFabric     fabric("twill 2/2", 4, 2);
  MatrixMeshDescription description;
  description.n_cells = {{28, 28, 11}};
  const MatrixMesh   with_holes(description, fabric.fibers, fabric.nodes);
  const FiberVolumes part = fiber_volumes(with_holes, fabric.fibers);
  description.leave_out   = false;
  const MatrixMesh   whole(description, fabric.fibers, fabric.nodes);
  const FiberVolumes all = fiber_volumes(whole, fabric.fibers);

  const auto in_cells = [](const FiberVolumes &volumes) {
    return std::accumulate(
      volumes.in_cells.begin(), volumes.in_cells.end(), 0.);
  };
  deallog << "Thickness over volume by area "
          << with_holes.grid().mean_thickness() *
               whole.grid().columns().area() / whole.volume()
          << "; fibers in the grid over those in all its cells "
          << all.in_grid / in_cells(all) << ", in the mesh with holes "
          << in_cells(part) / in_cells(all) << ", in its grid within 0.1 %: "
          << (std::abs(part.in_grid / all.in_grid - 1.) < 1e-3) << std::endl;
}



int
main()
{
  initlog();
  run_part("Triangulation", triangulations);
  run_part("Loose cells", loose_cells);
  run_part("Volumes of fibers", volumes_of_fibers);
  run_part("Sizes of a ply", sizes_of_a_ply);
}
