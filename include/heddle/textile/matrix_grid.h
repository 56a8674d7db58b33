#ifndef heddle_textile_matrix_grid_h
#define heddle_textile_matrix_grid_h

#include <heddle/textile/fiber_axis.h>
#include <heddle/textile/layered_grid.h>
#include <heddle/textile/matrix_mesh_description.h>
#include <heddle/textile/yarn_body.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace Textile
  {
    /** Throw InputError, which begins with @p where, if what does not depend on
     * the fibers makes no matrix. */
    void
    check_description(const MatrixMeshDescription &description,
                      const std::string           &where);

    /**
     * The grid from which the cells of a matrix are taken: its rectangle, the
     * number of its cells and its surfaces.
     *
     * Along x the rectangle reaches as far as all yarns along x do, so that
     * each of them comes out of its side, or as far as the yarns along y lie,
     * whichever is wider; along y alike. Its corners may be without any yarn.
     *
     * Numbers of cells that are 0 are chosen such that columns are about 2.5
     * fiber radii or, if that is more, a quarter of the yarns' height wide, and
     * layers 0.6 times as high: then some fit into the inside of a yarn of four
     * rows. There are two layers or more.
     *
     * @p bodies are those of the fibers' yarns. Throws InputError, which begins
     * with @p where, if the description does not give a grid of sound cells.
     */
    LayeredGrid
    matrix_grid(const MatrixMeshDescription  &description,
                const std::vector<FiberAxis> &fibers,
                const std::vector<YarnBody>  &bodies,
                const std::string            &where);
  } // namespace Textile
} // namespace Heddle

#endif
