#ifndef heddle_textile_fiber_volume_h
#define heddle_textile_fiber_volume_h

#include <heddle/textile/matrix_mesh.h>

#include <vector>

namespace Heddle
{
  namespace Textile
  {
    /**
     * Volume of @p fibers in each cell of @p mesh [mm^3]. Fibers are cut into
     * parts of equal volume as long and as wide as a quarter of a cell, but no
     * thinner than the fiber: cells that are finer than fibers have their part
     * of the section each.
     */
    std::vector<double>
    fiber_volumes(const MatrixMesh &mesh, const std::vector<FiberAxis> &fibers);
  } // namespace Textile
} // namespace Heddle

#endif
