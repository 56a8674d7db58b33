#ifndef heddle_textile_column_grid_h
#define heddle_textile_column_grid_h

#include <deal.II/base/point.h>

#include <array>

namespace Heddle
{
  namespace Textile
  {
    using namespace dealii;

    /**
     * A rectangle in the plane of the fabric, cut into columns of equal size.
     * Columns and their corners are numbered along x first.
     */
    struct ColumnGrid
    {
      Point<2>                    low;  /**< [mm] */
      Point<2>                    high; /**< [mm] */
      std::array<unsigned int, 2> n_columns = {{1, 1}};

      /** Extent of a column along axis @p d [mm]. */
      double
      size(const unsigned int d) const
      {
        return (high[d] - low[d]) / n_columns[d];
      }

      /** Of the whole rectangle [mm^2]. */
      double
      area() const
      {
        return (high[0] - low[0]) * (high[1] - low[1]);
      }

      unsigned int
      n_corners() const
      {
        return (n_columns[0] + 1) * (n_columns[1] + 1);
      }

      unsigned int
      corner(const unsigned int i, const unsigned int j) const
      {
        return j * (n_columns[0] + 1) + i;
      }

      /** Place of line number @p i across axis @p d [mm]. */
      double
      line(const unsigned int d, const unsigned int i) const
      {
        return i == n_columns[d] ? high[d] : low[d] + i * size(d);
      }
    };
  } // namespace Textile
} // namespace Heddle

#endif
