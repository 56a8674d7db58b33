// The mesh of a matrix: the parameters that describe it, its volume and its
// cells, and what is refused in one sentence.
#include <heddle/base/exceptions.h>
#include <heddle/textile/matrix_mesh.h>
#include <heddle/textile/matrix_mesh_parameters.h>

#include "../tests.h"
#include "woven_fabric.h"

#include <functional>
#include <random>

using namespace Heddle::Textile;

struct Section : ParameterAcceptor
{
  Section()
    : ParameterAcceptor("/Matrix")
  {
    mesh.add_parameters(*this);
  }

  MatrixMeshParameters mesh;
};



/**
 * The entries describe a mesh; without any of them it is the coating of a
 * fabric.
 */
void
parameters()
{
  const Section section;
  for (const std::string entries :
       {"",
        "subsection Matrix\nset Shape = block\nset Columns x = 3\n"
        "set Columns y = 4\nset Layers = 5\nset Coating thickness = 0.5\n"
        "set Margin x = -0.1\nset Margin y = 0.2\nset Overlap depth = 2\n"
        "set Leave out cells inside yarns = false\n"
        "set Lower corner = -1, -2, -3\nset Upper corner = 4, 5, 6\nend\n"})
    {
      ParameterAcceptor::prm.parse_input_from_string(entries);
      ParameterAcceptor::parse_all_parameters();
      const MatrixMeshDescription mesh = section.mesh.description();
      deallog << (mesh.shape == MatrixShape::block ? "block, " : "fabric, ")
              << mesh.n_cells[0] << " x " << mesh.n_cells[1] << " x "
              << mesh.n_cells[2] << " cells, coating " << mesh.coating_thickness
              << ", margins " << mesh.margins[0] << " and " << mesh.margins[1]
              << ", leave out " << mesh.leave_out << ", overlap "
              << mesh.overlap_depth << ", from " << mesh.low_corner << " to "
              << mesh.high_corner << std::endl;
    }
}



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



/**
 * The mesh finds each point of its cells and none elsewhere; its volume is that
 * of the block, or what lies between the surfaces of the fabric.
 */
void
places_and_volumes()
{
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



void
refuse(WovenFabric                                         fabric,
       const std::function<void(MatrixMeshDescription &)> &spoil)
{
  MatrixMeshDescription description;
  spoil(description);
  try
    {
      const MatrixMesh mesh(description, fabric.fibers, fabric.nodes);
      deallog << "accepted" << std::endl;
    }
  catch (const Heddle::InputError &error)
    {
      deallog << error.what() << std::endl;
    }
}



/**
 * A mesh that cannot be is refused in one sentence that names the parameter.
 */
void
no_meshes()
{
  const WovenFabric plain("plain", 2);

  WovenFabric none = plain;
  none.fibers.clear();
  refuse(none, [](auto &) {});

  refuse(plain, [](auto &mesh) { mesh.coating_thickness = -0.01; });
  refuse(plain, [](auto &mesh) { mesh.overlap_depth = -1.; });
  refuse(plain, [](auto &mesh) { mesh.margins[0] = -0.25; });
  refuse(plain, [](auto &mesh) { mesh.margins[1] = -0.25; });
  refuse(plain, [](auto &mesh) { mesh.n_cells = {{10000, 2000, 1}}; });
  refuse(plain, [](auto &mesh) { mesh.n_cells = {{500, 500, 50}}; });
  refuse(plain, [](auto &mesh) { mesh.n_cells = {{2, 2, 400}}; });
  refuse(plain, [](auto &mesh) { mesh.n_cells = {{300, 2, 2}}; });
  refuse(plain, [](auto &mesh) {
    mesh.shape       = MatrixShape::block;
    mesh.high_corner = {1., -1., 1.};
  });
  refuse(plain, [](auto &mesh) {
    mesh.shape         = MatrixShape::block;
    mesh.overlap_depth = 0.;
    mesh.low_corner    = {-0.002, 0.028, -0.001};
    mesh.high_corner   = {0.002, 0.03, 0.001};
    mesh.n_cells       = {{1, 1, 1}};
  });

  // Two fibers far apart: nothing lies between them in a small rectangle.
  WovenFabric two = plain;
  two.fibers.resize(2);
  for (unsigned int f = 0; f < 2; ++f)
    {
      two.fibers[f].yarn_id = no_id;
      two.fibers[f].radius  = 0.001;
      two.fibers[f].points  = {Tensor<1, 3>({-1., 2. * f, 0.}),
                               Tensor<1, 3>({1., 2. * f, 0.})};
    }
  refuse(two, [](auto &mesh) { mesh.margins[1] = -0.9; });

  // A high wall beside a single fiber.
  two.fibers.push_back(two.fibers[1]);
  for (Tensor<1, 3> &point : two.fibers[2].points)
    point[2] = 8.;
  refuse(two, [](auto &mesh) {
    mesh.coating_thickness = 0.;
    mesh.n_cells           = {{20, 20, 1}};
  });
}



int
main()
{
  initlog();
  run_part("Parameters", parameters);
  run_part("Places and volumes", places_and_volumes);
  run_part("What is no mesh", no_meshes);
}
