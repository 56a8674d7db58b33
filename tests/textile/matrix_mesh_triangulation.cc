// deal.II makes a triangulation of the mesh without complaints: no distorted
// cells, the volume of the mesh, and the promised ids at all sides.
#include <heddle/textile/matrix_mesh.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include "../tests.h"
#include "woven_fabric.h"

#include <array>

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
check(const std::string &pattern, const bool leave_out)
{
  const WovenFabric     fabric(pattern, 4, 2);
  MatrixMeshDescription description;
  description.leave_out = leave_out;
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



int
main()
{
  initlog();
  check("plain", true);
  check("twill 2/2", true);
  check("twill 2/2", false);
}
