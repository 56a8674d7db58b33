// Whatever the settings, cells are sound, those are kept that should be, and
// fibers lie below the surface by the thickness of the coating.
#include <heddle/textile/matrix_mesh.h>

#include "../tests.h"
#include "woven_fabric.h"

#include <algorithm>

using namespace Heddle::Textile;



/** Smallest determinant at a vertex over that of the mean cell. */
double
smallest_jacobian(const MatrixMesh &mesh)
{
  double       smallest = 1e300;
  const double mean     = mesh.volume() / mesh.cells().size();
  for (const MatrixMesh::Cell &cell : mesh.cells())
    for (unsigned int v = 0; v < 8; ++v)
      {
        Tensor<1, 3> edges[3];
        for (unsigned int d = 0; d < 3; ++d)
          edges[d] = mesh.vertices()[cell.vertices[v | (1u << d)]] -
                     mesh.vertices()[cell.vertices[v & ~(1u << d)]];
        smallest = std::min(
          smallest, cross_product_3d(edges[0], edges[1]) * edges[2] / mean);
      }
  return smallest;
}



/** Cells that are kept but should not be, or the other way round. */
unsigned int
count_wrongly_kept(const MatrixMesh            &mesh,
                   const MatrixMeshDescription &description,
                   const WovenFabric           &fabric)
{
  const double      depth = description.overlap_depth * fabric.radius;
  std::vector<bool> is_kept(mesh.grid().n_cells(), false);
  for (const MatrixMesh::Cell &cell : mesh.cells())
    is_kept[cell.number] = true;
  const auto   bodies  = yarn_bodies(fabric.fibers);
  unsigned int n_wrong = 0;
  for (unsigned int c = 0; c < is_kept.size(); ++c)
    {
      bool inside = false;
      for (const YarnBody &body : bodies)
        {
          bool all_deep =
            body.depth(mesh.grid().position(c, {0.5, 0.5, 0.5})) > depth;
          for (unsigned int v = 0; v < 8 && all_deep; ++v)
            all_deep = body.depth(mesh.grid().position(
                         c, Point<3>(v & 1, (v >> 1) & 1, v >> 2))) > depth;
          inside = inside || all_deep;
        }
      n_wrong += is_kept[c] == (description.leave_out && inside) ? 1 : 0;
    }
  return n_wrong;
}



/** Points of fiber surfaces that are not below the coating. */
unsigned int
count_bare_points(const MatrixMesh  &mesh,
                  const double       coating,
                  const WovenFabric &fabric)
{
  const ColumnGrid &columns = mesh.grid().columns();
  unsigned int      n_bare  = 0;
  for (const FiberAxis &fiber : fabric.fibers)
    for (const Tensor<1, 3> &axis : fiber.points)
      for (const double x : {-1., 0., 1.})
        for (const double y : {-1., 0., 1.})
          for (const double z : {-1., 1.})
            {
              const Tensor<1, 3> point(
                {axis[0] + x * fabric.radius,
                 axis[1] + y * fabric.radius,
                 axis[2] + z * (fabric.radius + coating * (1. - 1e-9))});
              if (point[0] > columns.low[0] && point[0] < columns.high[0] &&
                  point[1] > columns.low[1] && point[1] < columns.high[1])
                n_bare += mesh.grid().locate(point).cell == no_cell ? 1 : 0;
            }
  return n_bare;
}



/** Outermost fibers' nodes at the surface of the fabric that have no cell. */
unsigned int
count_free_nodes(const MatrixMesh            &mesh,
                 const MatrixMeshDescription &description,
                 const WovenFabric           &fabric)
{
  const auto   bodies = yarn_bodies(fabric.fibers);
  unsigned int n_free = 0;
  for (const FiberAxis &fiber : fabric.fibers)
    for (const Tensor<1, 3> &axis : fiber.points)
      if (bodies[fiber.yarn_id].depth(axis) <
            (description.overlap_depth - 1e-2) * fabric.radius &&
          mesh.grid().locate(axis).cell != no_cell)
        n_free += mesh.locate(axis).cell == no_cell ? 1 : 0;
  return n_free;
}



void
scan(const std::string &pattern, const MatrixShape shape)
{
  const WovenFabric     fabric(pattern);
  MatrixMeshDescription description;
  description.shape     = shape;
  unsigned int n_meshes = 0, n_bare = 0, n_wrong = 0, n_free = 0;
  unsigned int n_smaller = 0, n_dropped = 0;
  double       jacobian = 1e300;
  for (const unsigned int n_columns : {3, 14, 30})
    for (const unsigned int n_layers : {1, 5, 14})
      for (const double overlap : {0., 1.25, 2.5})
        for (const double coating : {0., 0.01})
          {
            description.n_cells       = {{n_columns, n_columns + 1, n_layers}};
            description.overlap_depth = overlap;
            description.coating_thickness = coating;
            const MatrixMesh mesh(description, fabric.fibers, fabric.nodes);
            ++n_meshes;
            n_smaller += mesh.n_left_out() > 0 ? 1 : 0;
            n_dropped += mesh.dropped().n_cells;
            jacobian = std::min(jacobian, smallest_jacobian(mesh));
            n_bare += count_bare_points(mesh, coating, fabric);
            n_free += count_free_nodes(mesh, description, fabric);
            // One by one is slow.
            if (n_columns < 30 && coating > 0.)
              n_wrong += count_wrongly_kept(mesh, description, fabric);
          }
  deallog << pattern
          << (shape == MatrixShape::block ? ", block: " : ", fabric: ")
          << n_meshes << " meshes, " << n_smaller
          << " with cells left out, dropped " << n_dropped
          << "; smallest Jacobian above 0.3: " << (jacobian > 0.3)
          << ", wrongly kept or left out " << n_wrong << ", bare points "
          << n_bare << ", free outermost nodes " << n_free << std::endl;
}



int
main()
{
  initlog();
  for (const std::string pattern : {"plain", "twill 2/2"})
    for (const MatrixShape shape : {MatrixShape::fabric, MatrixShape::block})
      scan(pattern, shape);
}
