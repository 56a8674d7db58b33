#include <heddle/base/choice.h>
#include <heddle/textile/matrix_mesh_parameters.h>

#include <deal.II/base/patterns.h>

namespace Heddle
{
  namespace Textile
  {
    void
    MatrixMeshParameters::add_parameters(ParameterAcceptor &owner)
    {
      ParameterHandler &prm = ParameterAcceptor::prm;
      add_choice(owner,
                 "Shape",
                 mesh.shape,
                 "What the mesh looks like: 'fabric' (a coating whose "
                 "surfaces follow the fabric) or 'block' (a box) [-].");
      for (const unsigned int d : {0, 1})
        {
          const std::string axis(1, "xy"[d]);
          owner.add_parameter("Columns " + axis,
                              mesh.n_cells[d],
                              "Number of cells along " + axis +
                                ", at least 1. 0: columns are 2.5 fiber "
                                "radii or, if that is more, a quarter of the "
                                "yarns' height wide [-].",
                              prm,
                              Patterns::Integer(0));
        }
      owner.add_parameter("Layers",
                          mesh.n_cells[2],
                          "Number of cells through the thickness, at least 1. "
                          "0: they are 0.6 times as high as automatic columns "
                          "are wide, and two or more [-].",
                          prm,
                          Patterns::Integer(0));
      owner.add_parameter("Coating thickness",
                          mesh.coating_thickness,
                          "Matrix above the highest and below the lowest "
                          "fibers, at least 0. Inactive for a block whose "
                          "corners are given [mm].",
                          prm,
                          Patterns::Double(0.));
      for (const unsigned int d : {0, 1})
        {
          const std::string axis(1, "xy"[d]), other(1, "yx"[d]);
          owner.add_parameter(
            "Margin " + axis,
            mesh.margins[d],
            "By how much the mesh extends at both ends "
            "along " +
              axis + " beyond the rectangle that all yarns along " + axis +
              " reach through and all yarns along " + other +
              " lie in; negative cuts. Inactive for a block "
              "whose corners are given [mm].",
            prm,
            Patterns::Double());
        }
      owner.add_parameter("Leave out cells inside yarns",
                          mesh.leave_out,
                          "Whether cells deep inside of yarns are left out. If "
                          "false, matrix is between all fibers [-].");
      owner.add_parameter("Overlap depth",
                          mesh.overlap_depth,
                          "How far below the surface of a yarn cells may begin "
                          "that are kept, in fiber radii, at least 0. From 1 "
                          "on the outermost fibers lie in cells. Inactive if "
                          "no cells are left out [-].",
                          prm,
                          Patterns::Double(0.));
      owner.add_parameter("Lower corner",
                          mesh.low_corner,
                          "Corner of the block with the smallest coordinates. "
                          "If it equals the upper one, the block lies around "
                          "the fibers. Inactive unless Shape is 'block' [mm].");
      owner.add_parameter("Upper corner",
                          mesh.high_corner,
                          "Corner of the block with the largest coordinates. "
                          "Inactive unless Shape is 'block' [mm].");
    }
  } // namespace Textile
} // namespace Heddle
