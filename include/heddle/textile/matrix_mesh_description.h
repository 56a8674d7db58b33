#ifndef heddle_textile_matrix_mesh_description_h
#define heddle_textile_matrix_mesh_description_h

#include <deal.II/base/point.h>

#include <array>

namespace Heddle
{
  namespace Textile
  {
    using namespace dealii;

    /** What the outer surfaces of a matrix look like. */
    enum class MatrixShape
    {
      /** Lower and upper surface follow the fabric. */
      fabric,
      /** A box. */
      block
    };

    /** How the user names them. */
    constexpr const char *
    word(const MatrixShape shape)
    {
      switch (shape)
        {
          case MatrixShape::fabric:
            return "fabric";
          case MatrixShape::block:
            return "block";
        }
      return nullptr;
    }



    /** The mesh of a matrix around a fabric, as the user describes it. */
    struct MatrixMeshDescription
    {
      MatrixShape shape = MatrixShape::fabric;

      /** Columns along x and along y, layers; 0: chosen by the program. */
      std::array<unsigned int, 3> n_cells = {{0, 0, 0}};

      /** Matrix above the highest and below the lowest fibers [mm]. */
      double coating_thickness = 0.01;

      /** By how much the rectangle is larger than the fabric at each side [mm].
       */
      std::array<double, 2> margins = {{0., 0.}};

      /** Whether cells deep inside of yarns are left out. */
      bool leave_out = true;

      /** How deep cells reach into yarns at least, in fiber radii [-]. */
      double overlap_depth = 1.25;

      /** Opposite corners of a block; if equal it lies around the fibers [mm].
       */
      Point<3> low_corner;
      Point<3> high_corner;
    };
  } // namespace Textile
} // namespace Heddle

#endif
