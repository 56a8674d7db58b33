#ifndef heddle_textile_layered_grid_h
#define heddle_textile_layered_grid_h

#include <heddle/textile/column_grid.h>

#include <array>
#include <limits>
#include <vector>

namespace Heddle
{
  namespace Textile
  {
    /** "No cell is there." */
    constexpr unsigned int no_cell = std::numeric_limits<unsigned int>::max();



    /** A cell, and a place in it. */
    struct PlaceInCell
    {
      unsigned int cell = no_cell;

      /** In [0,1]^3. */
      Point<3> unit;
    };



    /**
     * Columns between a lower and an upper surface, cut into layers:
     * vertex (i,j,k) lies at
     * @f[ z = z^-_{ij} + (z^+_{ij} - z^-_{ij}) \, k / n_z, @f]
     * over the corner (i,j) of the columns. Cells are prisms over equal
     * rectangles, and the surfaces between them are bilinear in x and y: a
     * point is found in closed form. Cells and vertices are numbered along x
     * first, then y, then z.
     */
    class LayeredGrid
    {
    public:
      using Index = std::array<unsigned int, 3>;

      /** @p lower and @p upper are given at the corners of the columns [mm]. */
      LayeredGrid(const ColumnGrid          &columns,
                  const std::vector<double> &lower,
                  const std::vector<double> &upper,
                  const unsigned int         n_layers);

      const ColumnGrid &
      columns() const
      {
        return base;
      }

      /** Cells along x, y and z. */
      Index
      n_along() const
      {
        return {{base.n_columns[0], base.n_columns[1], n_layers}};
      }

      unsigned int
      n_cells() const
      {
        return base.n_columns[0] * base.n_columns[1] * n_layers;
      }

      unsigned int
      n_vertices() const
      {
        return base.n_corners() * (n_layers + 1);
      }

      unsigned int
      cell(const Index &index) const
      {
        return (index[2] * base.n_columns[1] + index[1]) * base.n_columns[0] +
               index[0];
      }

      unsigned int
      vertex(const Index &index) const
      {
        return index[2] * base.n_corners() + base.corner(index[0], index[1]);
      }

      Index
      index_of_cell(const unsigned int cell) const;

      Index
      index_of_vertex(const unsigned int vertex) const;

      /** Numbers of the vertices of a cell, along x first, then y, then z. */
      std::array<unsigned int, 8>
      vertices_of(const unsigned int cell) const;

      /** Place of a vertex [mm]. */
      Point<3>
      position(const unsigned int vertex) const;

      /** Place of the point @p unit of a cell: the trilinear map [mm]. */
      Point<3>
      position(const unsigned int cell, const Point<3> &unit) const;

      /**
       * The cell in which @p point lies, and where; no_cell outside. A point
       * between two cells belongs to the one with the larger number.
       */
      PlaceInCell
      locate(const Tensor<1, 3> &point) const;

      /** Volume of a cell: exact [mm^3]. */
      double
      volume(const unsigned int cell) const;

      /** Mean distance of the surfaces [mm]. */
      double
      mean_thickness() const;

      /** Distance of the surfaces over a corner of the columns [mm]. */
      double
      thickness(const unsigned int corner) const
      {
        return upper[corner] - lower[corner];
      }

    private:
      /** Numbers of the corners of the column in which a cell lies. */
      std::array<unsigned int, 4>
      corners_of(const unsigned int i, const unsigned int j) const;

      ColumnGrid          base;
      std::vector<double> lower;
      std::vector<double> upper;
      unsigned int        n_layers;
    };
  } // namespace Textile
} // namespace Heddle

#endif
