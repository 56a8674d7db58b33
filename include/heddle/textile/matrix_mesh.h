#ifndef heddle_textile_matrix_mesh_h
#define heddle_textile_matrix_mesh_h

#include <heddle/textile/fiber_axis.h>
#include <heddle/textile/kept_cells.h>
#include <heddle/textile/layered_grid.h>
#include <heddle/textile/matrix_mesh_description.h>

#include <array>
#include <string>
#include <vector>

namespace Heddle
{
  namespace Textile
  {
    /**
     * Hexahedra of the elastic matrix around a fabric: the cells of a
     * LayeredGrid that are not deep inside of a yarn. External fibers of yarns
     * lie in cells, and so the mesh overlaps the yarns.
     *
     * Everything here is geometry; vertices and cells are in the order that
     * deal.II wants.
     */
    class MatrixMesh
    {
    public:
      struct Cell
      {
        /** Numbers of the vertices, along x first, then y, then z. */
        std::array<unsigned int, 8> vertices;

        /** Number of the cell in the grid. */
        unsigned int number;
      };

      /** What a face at the boundary belongs to; values are boundary ids. */
      enum Side
      {
        x_low  = 0,
        x_high = 1,
        y_low  = 2,
        y_high = 3,
        bottom = 4,
        top    = 5,
        /** Towards yarns, where cells were left out. */
        inner = 6
      };

      /** A face of a cell that no other cell has. */
      struct BoundaryFace
      {
        unsigned int cell;
        /** In deal.II's order: x-, x+, y-, y+, z-, z+. */
        unsigned int face;
        Side         side;
      };

      /**
       * Make the mesh around @p fibers. Their polylines may be finer than the
       * fibers' elements; @p nodes are the points that will be tied to the
       * matrix: what none of them holds is dropped.
       *
       * Throws InputError, which begins with @p where, if the description does
       * not give sound cells or leaves none of them.
       */
      MatrixMesh(const MatrixMeshDescription     &description,
                 const std::vector<FiberAxis>    &fibers,
                 const std::vector<Tensor<1, 3>> &nodes,
                 const std::string               &where = "Matrix");

      /** The grid from which the cells are taken. */
      const LayeredGrid &
      grid() const
      {
        return pattern;
      }

      /** Places of the vertices; each belongs to a cell [mm]. */
      const std::vector<Point<3>> &
      vertices() const
      {
        return places;
      }

      const std::vector<Cell> &
      cells() const
      {
        return kept_cells;
      }

      const std::vector<BoundaryFace> &
      boundary() const
      {
        return faces;
      }

      /** Number in cells() of a cell of the grid; no_cell if it is left out. */
      unsigned int
      number_of(const unsigned int cell_of_grid) const
      {
        return numbers_of_cells[cell_of_grid];
      }

      /**
       * The cell, as a number in cells(), in which @p point lies, and where;
       * no_cell outside and in cells that were left out.
       */
      PlaceInCell
      locate(const Tensor<1, 3> &point) const;

      /** Volume of the cell with this number in cells() [mm^3]. */
      double
      volume(const unsigned int cell) const
      {
        return pattern.volume(kept_cells[cell].number);
      }

      /** Volume of all cells [mm^3]. */
      double
      volume() const;

      /** Cells of the grid that lie deep inside of yarns. */
      unsigned int
      n_left_out() const
      {
        return n_inside;
      }

      /** What was dropped because no fiber held it. */
      const DroppedCells &
      dropped() const
      {
        return loose;
      }

    private:
      /** Number the kept cells and the vertices that they use. */
      void
      number_cells(const KeptCells &kept);

      /** Find the faces that only one cell has. */
      void
      find_boundary();

      LayeredGrid               pattern;
      std::vector<Point<3>>     places;
      std::vector<Cell>         kept_cells;
      std::vector<BoundaryFace> faces;

      /** Number in cells() for each cell of the grid, or no_cell. */
      std::vector<unsigned int> numbers_of_cells;
      unsigned int              n_inside = 0;
      DroppedCells              loose;
    };
  } // namespace Textile
} // namespace Heddle

#endif
