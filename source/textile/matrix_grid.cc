#include <heddle/base/exceptions.h>
#include <heddle/textile/fabric_envelope.h>
#include <heddle/textile/fabric_reach.h>
#include <heddle/textile/matrix_grid.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      /** More cells than this are a mistake. */
      constexpr double most_cells = 1e7;

      /** Larger ratios of the extents of a cell are a mistake. */
      constexpr double largest_aspect_ratio = 100.;

      /** Cells that are thinner at a corner, over their mean, are a mistake. */
      constexpr double smallest_thinning = 0.05;



      /** Cells that the program chooses are flatter than wide. */
      constexpr double automatic_flatness = 0.6;



      /** Put a sentence together. */
      template <typename... Parts>
      std::string
      sentence_of(const Parts &...parts)
      {
        std::ostringstream sentence;
        (sentence << ... << parts);
        return sentence.str();
      }



      /** Whether the user gave the corners of the block. */
      bool
      has_corners(const MatrixMeshDescription &description)
      {
        return description.shape == MatrixShape::block &&
               description.low_corner != description.high_corner;
      }



      ColumnGrid
      rectangle_of(const MatrixMeshDescription  &description,
                   const std::vector<FiberAxis> &fibers,
                   const std::string            &where)
      {
        ColumnGrid columns;
        for (unsigned int d = 0; d < 2; ++d)
          if (has_corners(description))
            {
              columns.low[d]  = description.low_corner[d];
              columns.high[d] = description.high_corner[d];
            }
          else
            {
              const Extent reach = reach_along(fibers, d);
              columns.low[d]     = reach.low - description.margins[d];
              columns.high[d]    = reach.high + description.margins[d];
              require(columns.low[d] < columns.high[d],
                      sentence_of(where,
                                  ": \"Margin ",
                                  "xy"[d],
                                  "\" is ",
                                  description.margins[d],
                                  " mm and leaves nothing of a fabric that is ",
                                  reach.high - reach.low,
                                  " mm wide; choose a larger one."));
            }
        return columns;
      }



      /** Width of the columns that the program chooses [mm]. */
      double
      automatic_size(const std::vector<FiberAxis> &fibers,
                     const std::vector<YarnBody>  &bodies)
      {
        double size = 0.;
        for (const FiberAxis &fiber : fibers)
          size += 2.5 * fiber.radius / fibers.size();
        double height = 0.;
        for (const YarnBody &body : bodies)
          height += body.height() / bodies.size();
        return std::max(size, 0.25 * height);
      }



      unsigned int
      number_of_cells(const unsigned int wanted,
                      const double       extent,
                      const double       size,
                      const unsigned int at_least)
      {
        return wanted > 0 ? wanted
                          : std::max<unsigned int>(
                              at_least,
                              std::lround(std::min(extent / size, most_cells)));
      }



      void
      check_number_of_cells(const double n_cells, const std::string &where)
      {
        require(n_cells <= most_cells,
                sentence_of(where,
                            ": \"Columns x\", \"Columns y\" and \"Layers\" "
                            "make ",
                            n_cells,
                            " cells, and ",
                            most_cells,
                            " are the limit; choose fewer."));
      }



      /** Surfaces of a box at the corners of the columns. */
      Envelope
      box_envelope(const MatrixMeshDescription  &description,
                   const std::vector<FiberAxis> &fibers,
                   const ColumnGrid             &columns)
      {
        Extent height{description.low_corner[2], description.high_corner[2]};
        if (!has_corners(description))
          {
            height = extent_of(fibers, 2);
            height.low -= description.coating_thickness;
            height.high += description.coating_thickness;
          }
        return {std::vector<double>(columns.n_corners(), height.low),
                std::vector<double>(columns.n_corners(), height.high)};
      }



      bool
      some_fiber_over(const ColumnGrid             &columns,
                      const std::vector<FiberAxis> &fibers)
      {
        for (const FiberAxis &fiber : fibers)
          for (const Tensor<1, 3> &point : fiber.points)
            if (point[0] >= columns.low[0] && point[0] <= columns.high[0] &&
                point[1] >= columns.low[1] && point[1] <= columns.high[1])
              return true;
        return false;
      }



      Envelope
      coated_envelope(const MatrixMeshDescription  &description,
                      const std::vector<FiberAxis> &fibers,
                      const ColumnGrid             &columns,
                      const std::string            &where)
      {
        require(some_fiber_over(columns, fibers),
                where + ": \"Margin x\" and \"Margin y\" leave a rectangle in "
                        "which no fiber lies; choose larger ones.");
        Envelope envelope = fabric_envelope(columns, fibers);
        for (double &height : envelope.lower)
          height -= description.coating_thickness;
        for (double &height : envelope.upper)
          height += description.coating_thickness;
        return envelope;
      }



      /** Complain if cells are too flat, too slim or too much of a wedge. */
      void
      check_cells(const LayeredGrid &grid, const std::string &where)
      {
        const ColumnGrid &columns = grid.columns();
        const unsigned    n_z     = grid.n_along()[2];
        Extent            height;
        for (unsigned int c = 0; c < columns.n_corners(); ++c)
          height.add(grid.thickness(c) / n_z);
        const double widest   = std::max(columns.size(0), columns.size(1));
        const double slimmest = std::min(columns.size(0), columns.size(1));
        require(widest <= largest_aspect_ratio * height.low,
                sentence_of(where,
                            ": \"Layers\" makes layers of ",
                            height.low,
                            " mm between columns of ",
                            widest,
                            " mm; choose fewer layers or more columns."));
        require(height.high <= largest_aspect_ratio * slimmest &&
                  widest <= largest_aspect_ratio * slimmest,
                sentence_of(where,
                            ": \"Columns x\" and \"Columns y\" make columns of "
                            "down to ",
                            slimmest,
                            " mm, while cells are up to ",
                            std::max(height.high, widest),
                            " mm long; choose numbers that make them more "
                            "alike."));
        for (unsigned int j = 0; j < columns.n_columns[1]; ++j)
          for (unsigned int i = 0; i < columns.n_columns[0]; ++i)
            {
              Extent thickness;
              double sum = 0.;
              for (unsigned int v = 0; v < 4; ++v)
                {
                  const double t =
                    grid.thickness(columns.corner(i + (v & 1), j + (v >> 1)));
                  thickness.add(t);
                  sum += t;
                }
              require(thickness.low >= smallest_thinning * 0.25 * sum,
                      sentence_of(where,
                                  ": \"Coating thickness\" leaves the matrix ",
                                  thickness.low,
                                  " mm thin beside fibers where it is ",
                                  thickness.high,
                                  " mm; choose a thicker coating, more columns "
                                  "or a block."));
            }
      }
    } // namespace



    void
    check_description(const MatrixMeshDescription &description,
                      const std::string           &where)
    {
      require(description.coating_thickness >= 0.,
              sentence_of(where,
                          ": \"Coating thickness\" is ",
                          description.coating_thickness,
                          " mm; it must be 0 or more."));
      require(description.overlap_depth >= 0.,
              sentence_of(where,
                          ": \"Overlap depth\" is ",
                          description.overlap_depth,
                          "; it must be 0 or more."));
      if (has_corners(description))
        for (unsigned int d = 0; d < 3; ++d)
          require(description.low_corner[d] < description.high_corner[d],
                  sentence_of(where,
                              ": \"Lower corner\" must be below \"Upper "
                              "corner\" in each coordinate, and ",
                              "xyz"[d],
                              " is ",
                              description.low_corner[d],
                              " and ",
                              description.high_corner[d],
                              " mm."));
    }



    LayeredGrid
    matrix_grid(const MatrixMeshDescription  &description,
                const std::vector<FiberAxis> &fibers,
                const std::vector<YarnBody>  &bodies,
                const std::string            &where)
    {
      require(!fibers.empty(), where + ": there are no fibers to embed.");
      check_description(description, where);
      ColumnGrid   columns = rectangle_of(description, fibers, where);
      const double size    = automatic_size(fibers, bodies);
      for (unsigned int d = 0; d < 2; ++d)
        columns.n_columns[d] = number_of_cells(
          description.n_cells[d], columns.high[d] - columns.low[d], size, 1);
      const double n_columns =
        double(columns.n_columns[0]) * columns.n_columns[1];
      // Before surfaces are made over all of them.
      check_number_of_cells(n_columns * std::max(1u, description.n_cells[2]),
                            where);

      const Envelope envelope =
        description.shape == MatrixShape::block
          ? box_envelope(description, fibers, columns)
          : coated_envelope(description, fibers, columns, where);
      double thickness = 0.;
      for (unsigned int c = 0; c < columns.n_corners(); ++c)
        thickness +=
          (envelope.upper[c] - envelope.lower[c]) / columns.n_corners();
      const unsigned int n_layers = number_of_cells(
        description.n_cells[2], thickness, automatic_flatness * size, 2);
      check_number_of_cells(
        double(columns.n_columns[0]) * columns.n_columns[1] * n_layers, where);

      const LayeredGrid grid(columns, envelope.lower, envelope.upper, n_layers);
      check_cells(grid, where);
      return grid;
    }
  } // namespace Textile
} // namespace Heddle
