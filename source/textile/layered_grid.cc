#include <heddle/textile/layered_grid.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      /** The value at (xi, eta) between those of four corners, along x first.
       */
      double
      between_corners(const std::vector<double>         &values,
                      const std::array<unsigned int, 4> &corners,
                      const double                       xi,
                      const double                       eta)
      {
        return (1. - eta) *
                 ((1. - xi) * values[corners[0]] + xi * values[corners[1]]) +
               eta * ((1. - xi) * values[corners[2]] + xi * values[corners[3]]);
      }



      /**
       * Split @p place, counted in cells, into the number of the cell and the
       * rest; tell whether there is such a cell. Round-off does not put a point
       * of the boundary outside.
       */
      bool
      split_place(const double       place,
                  const unsigned int n_cells,
                  unsigned int      &cell,
                  double            &rest)
      {
        constexpr double tolerance = 1e-10;
        if (!(place >= -tolerance && place <= n_cells + tolerance))
          return false;
        cell = std::min<unsigned int>(std::max(place, 0.), n_cells - 1);
        rest = std::clamp(place - cell, 0., 1.);
        return true;
      }
    } // namespace



    LayeredGrid::LayeredGrid(const ColumnGrid          &columns,
                             const std::vector<double> &lower,
                             const std::vector<double> &upper,
                             const unsigned int         n_layers)
      : base(columns)
      , lower(lower)
      , upper(upper)
      , n_layers(n_layers)
    {
      AssertDimension(lower.size(), columns.n_corners());
      AssertDimension(upper.size(), columns.n_corners());
    }



    LayeredGrid::Index
    LayeredGrid::index_of_cell(const unsigned int cell) const
    {
      const unsigned int row = cell / base.n_columns[0];
      return {{cell % base.n_columns[0],
               row % base.n_columns[1],
               row / base.n_columns[1]}};
    }



    LayeredGrid::Index
    LayeredGrid::index_of_vertex(const unsigned int vertex) const
    {
      const unsigned int corner = vertex % base.n_corners();
      return {{corner % (base.n_columns[0] + 1),
               corner / (base.n_columns[0] + 1),
               vertex / base.n_corners()}};
    }



    std::array<unsigned int, 8>
    LayeredGrid::vertices_of(const unsigned int cell) const
    {
      const Index                 index = index_of_cell(cell);
      std::array<unsigned int, 8> vertices;
      for (unsigned int v = 0; v < 8; ++v)
        vertices[v] = vertex({{index[0] + (v & 1),
                               index[1] + ((v >> 1) & 1),
                               index[2] + (v >> 2)}});
      return vertices;
    }



    Point<3>
    LayeredGrid::position(const unsigned int vertex) const
    {
      const Index        index  = index_of_vertex(vertex);
      const unsigned int corner = base.corner(index[0], index[1]);
      return Point<3>(base.line(0, index[0]),
                      base.line(1, index[1]),
                      lower[corner] + thickness(corner) * index[2] / n_layers);
    }



    Point<3>
    LayeredGrid::position(const unsigned int cell, const Point<3> &unit) const
    {
      const Index  index   = index_of_cell(cell);
      const auto   corners = corners_of(index[0], index[1]);
      const double bottom  = between_corners(lower, corners, unit[0], unit[1]);
      const double top     = between_corners(upper, corners, unit[0], unit[1]);
      return Point<3>(base.line(0, index[0]) + unit[0] * base.size(0),
                      base.line(1, index[1]) + unit[1] * base.size(1),
                      bottom +
                        (top - bottom) * (index[2] + unit[2]) / n_layers);
    }



    PlaceInCell
    LayeredGrid::locate(const Tensor<1, 3> &point) const
    {
      PlaceInCell place;
      Index       index;
      for (unsigned int d = 0; d < 2; ++d)
        if (!split_place((point[d] - base.low[d]) / base.size(d),
                         base.n_columns[d],
                         index[d],
                         place.unit[d]))
          return {};
      const auto   corners = corners_of(index[0], index[1]);
      const double bottom =
        between_corners(lower, corners, place.unit[0], place.unit[1]);
      const double top =
        between_corners(upper, corners, place.unit[0], place.unit[1]);
      if (!split_place((point[2] - bottom) / (top - bottom) * n_layers,
                       n_layers,
                       index[2],
                       place.unit[2]))
        return {};
      place.cell = cell(index);
      return place;
    }



    double
    LayeredGrid::volume(const unsigned int cell) const
    {
      const Index index = index_of_cell(cell);
      double      sum   = 0.;
      for (const unsigned int corner : corners_of(index[0], index[1]))
        sum += thickness(corner);
      return base.size(0) * base.size(1) * sum / (4. * n_layers);
    }



    double
    LayeredGrid::mean_thickness() const
    {
      double sum = 0.;
      for (unsigned int c = 0; c < n_cells(); ++c)
        sum += volume(c);
      return sum / base.area();
    }



    std::array<unsigned int, 4>
    LayeredGrid::corners_of(const unsigned int i, const unsigned int j) const
    {
      return {{base.corner(i, j),
               base.corner(i + 1, j),
               base.corner(i, j + 1),
               base.corner(i + 1, j + 1)}};
    }
  } // namespace Textile
} // namespace Heddle
