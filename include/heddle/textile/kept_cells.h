#ifndef heddle_textile_kept_cells_h
#define heddle_textile_kept_cells_h

#include <heddle/textile/layered_grid.h>
#include <heddle/textile/yarn_body.h>

#include <vector>

namespace Heddle
{
  namespace Textile
  {
    /** For each cell of a grid whether it belongs to the mesh. */
    using KeptCells = std::vector<bool>;



    /**
     * Keep the cells that are not deep inside of a yarn. A cell is if its eight
     * vertices and its middle lie deeper than @p overlap_depth radii of the
     * yarn's fibers below the surface of one and the same yarn. As depth is a
     * concave function inside of a section, every point that is not as deep
     * lies in a kept cell, if it lies in the grid.
     */
    KeptCells
    cells_outside_yarns(const LayeredGrid           &grid,
                        const std::vector<YarnBody> &bodies,
                        const double                 overlap_depth);

    /** The number of its component for each kept cell; no_cell for others. */
    struct Components
    {
      std::vector<unsigned int> of_cell;
      unsigned int              n_components = 0;
    };

    /** Cells that are connected by faces are of one component. */
    Components
    connected_components(const LayeredGrid &grid, const KeptCells &kept);

    /** What was taken away because nothing held it. */
    struct DroppedCells
    {
      unsigned int n_components = 0;
      unsigned int n_cells      = 0;
    };

    /**
     * Drop the components that could move freely: those that have no cell at
     * the sides x-, x+, y-, y+ of the grid, and that hold fewer than three of
     * the points @p nodes, or only such that lie on one line.
     */
    DroppedCells
    drop_loose_components(const LayeredGrid               &grid,
                          const std::vector<Tensor<1, 3>> &nodes,
                          KeptCells                       &kept);
  } // namespace Textile
} // namespace Heddle

#endif
