#ifndef heddle_textile_fiber_volume_h
#define heddle_textile_fiber_volume_h

#include <heddle/textile/matrix_mesh.h>

#include <vector>

namespace Heddle
{
  namespace Textile
  {
    /** How much fiber there is where a mesh is [mm^3]. */
    struct FiberVolumes
    {
      /** In each cell of the mesh. */
      std::vector<double> in_cells;

      /** In all of the mesh' grid, also where cells were left out. */
      double in_grid = 0.;
    };



    /**
     * Volumes of @p fibers in @p mesh. Fibers are cut into parts of equal
     * volume as long and as wide as a quarter of a cell, but no thinner than
     * the fiber: cells that are finer than fibers have their part of the
     * section each.
     */
    FiberVolumes
    fiber_volumes(const MatrixMesh &mesh, const std::vector<FiberAxis> &fibers);
  } // namespace Textile
} // namespace Heddle

#endif
