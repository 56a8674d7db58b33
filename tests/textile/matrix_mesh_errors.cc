// A mesh that cannot be is refused in one sentence that names the parameter.
#include <heddle/base/exceptions.h>
#include <heddle/textile/matrix_mesh.h>

#include "../tests.h"
#include "woven_fabric.h"

#include <functional>

using namespace Heddle::Textile;



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



int
main()
{
  initlog();
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
