#include <heddle/textile/fabric_envelope.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      /** Where no fiber is near. */
      constexpr double no_height = -std::numeric_limits<double>::max();



      /** Heights that the upper surface must not fall below. */
      class HeightRaster
      {
      public:
        HeightRaster(const ColumnGrid             &columns,
                     const std::vector<FiberAxis> &fibers,
                     const double                  radius,
                     const bool                    upside_down)
          : sign(upside_down ? -1. : 1.)
        {
          fine = columns;
          for (unsigned int d = 0; d < 2; ++d)
            {
              // Half a radius resolves a fiber.
              per_column[d] = std::clamp<int>(
                std::ceil(2. * columns.size(d) / radius), 2, 16);
              fine.n_columns[d] *= per_column[d];
            }
          heights.assign(fine.n_corners(), no_height);
          for (const FiberAxis &fiber : fibers)
            for (unsigned int s = 0; s + 1 < fiber.points.size(); ++s)
              add_segment(fiber.points[s], fiber.points[s + 1], fiber.radius);
        }

        /** Points of the raster per column along axis @p d. */
        unsigned int
        refinement(const unsigned int d) const
        {
          return per_column[d];
        }

        double
        height(const unsigned int i, const unsigned int j) const
        {
          return heights[fine.corner(i, j)];
        }

        /** Largest height within half a column of the corner (i,j). */
        double
        highest_around(const unsigned int i, const unsigned int j) const
        {
          const auto range = [this](const unsigned int d,
                                    const unsigned int n) {
            const int center = n * per_column[d],
                      half   = (per_column[d] + 1) / 2;
            return std::array<int, 2>{
              {std::max(0, center - half),
               std::min<int>(fine.n_columns[d], center + half)}};
          };
          const auto x = range(0, i), y = range(1, j);
          double     highest = no_height;
          for (int b = y[0]; b <= y[1]; ++b)
            for (int a = x[0]; a <= x[1]; ++a)
              highest = std::max(highest, height(a, b));
          return highest;
        }

      private:
        /** Cut a segment to pieces that are small on the raster. */
        void
        add_segment(const Tensor<1, 3> &a,
                    const Tensor<1, 3> &b,
                    const double        radius)
        {
          const double       pitch = std::min(fine.size(0), fine.size(1));
          const unsigned int n_pieces =
            std::max(1., std::ceil((b - a).norm() / pitch));
          for (unsigned int k = 0; k < n_pieces; ++k)
            add_piece(a + (b - a) * k / n_pieces,
                      a + (b - a) * (k + 1) / n_pieces,
                      radius);
        }

        /** Raise all corners of the fields that the box of a piece touches. */
        void
        add_piece(const Tensor<1, 3> &a,
                  const Tensor<1, 3> &b,
                  const double        radius)
        {
          const double height = std::max(sign * a[2], sign * b[2]) + radius;
          std::array<int, 2> first, last;
          for (unsigned int d = 0; d < 2; ++d)
            {
              const auto place = [&](const double x) {
                return std::clamp((x - fine.low[d]) / fine.size(d),
                                  -2.,
                                  fine.n_columns[d] + 2.);
              };
              first[d] = std::floor(place(std::min(a[d], b[d]) - radius));
              last[d]  = std::ceil(place(std::max(a[d], b[d]) + radius));
              first[d] = std::max(first[d], 0);
              last[d]  = std::min<int>(last[d], fine.n_columns[d]);
            }
          for (int j = first[1]; j <= last[1]; ++j)
            for (int i = first[0]; i <= last[0]; ++i)
              {
                double &here = heights[fine.corner(i, j)];
                here         = std::max(here, height);
              }
        }

        const double                sign;
        ColumnGrid                  fine;
        std::array<unsigned int, 2> per_column;
        std::vector<double>         heights;
      };



      /** Upper surface over the corners of the columns. */
      class Membrane
      {
      public:
        Membrane(const ColumnGrid &columns, const HeightRaster &raster)
          : columns(columns)
          , raster(raster)
          , heights(columns.n_corners())
        {
          for (unsigned int j = 0; j <= columns.n_columns[1]; ++j)
            for (unsigned int i = 0; i <= columns.n_columns[0]; ++i)
              heights[columns.corner(i, j)] = raster.highest_around(i, j);
        }

        /** Give every corner without height the mean of its neighbours. */
        void
        fill_holes()
        {
          while (std::find(heights.begin(), heights.end(), no_height) !=
                 heights.end())
            {
              std::vector<double> filled = heights;
              for (unsigned int c = 0; c < heights.size(); ++c)
                if (heights[c] == no_height)
                  filled[c] = mean_of_known_neighbours(c);
              heights.swap(filled);
            }
        }

        /** Mean over three corners along axis @p d, by the weights 1-2-1. */
        void
        smooth(const unsigned int d)
        {
          const std::vector<double> old  = heights;
          const unsigned int        step = d == 0 ? 1 : columns.corner(0, 1);
          for (unsigned int c = 0; c < heights.size(); ++c)
            {
              const unsigned int place  = place_along(c, d);
              const double       before = place == 0 ? old[c] : old[c - step];
              const double       after =
                place == columns.n_columns[d] ? old[c] : old[c + step];
              heights[c] = 0.25 * (before + 2. * old[c] + after);
            }
        }

        /**
         * Lift the surface above the raster: where it lies too low by v, and
         * the four corners have the weights w_a there, corner a is raised by
         * v w_a / |w|^2, the least that does it; each corner by the most that
         * a point of its columns asks for.
         */
        void
        lift()
        {
          std::vector<double> lifts(heights.size(), 0.);
          for (unsigned int j = 0; j < columns.n_columns[1]; ++j)
            for (unsigned int i = 0; i < columns.n_columns[0]; ++i)
              lift_column(i, j, lifts);
          for (unsigned int c = 0; c < heights.size(); ++c)
            heights[c] += lifts[c];
        }

        const std::vector<double> &
        result() const
        {
          return heights;
        }

      private:
        unsigned int
        place_along(const unsigned int corner, const unsigned int d) const
        {
          const unsigned int row = columns.n_columns[0] + 1;
          return d == 0 ? corner % row : corner / row;
        }

        double
        mean_of_known_neighbours(const unsigned int corner) const
        {
          double       sum     = 0.;
          unsigned int n_known = 0;
          const int    i = place_along(corner, 0), j = place_along(corner, 1);
          for (int b = std::max(0, j - 1);
               b <= std::min<int>(columns.n_columns[1], j + 1);
               ++b)
            for (int a = std::max(0, i - 1);
                 a <= std::min<int>(columns.n_columns[0], i + 1);
                 ++a)
              if (heights[columns.corner(a, b)] != no_height)
                {
                  sum += heights[columns.corner(a, b)];
                  ++n_known;
                }
          return n_known == 0 ? no_height : sum / n_known;
        }

        void
        lift_column(const unsigned int   i,
                    const unsigned int   j,
                    std::vector<double> &lifts) const
        {
          const std::array<unsigned int, 4> corners = {
            {columns.corner(i, j),
             columns.corner(i + 1, j),
             columns.corner(i, j + 1),
             columns.corner(i + 1, j + 1)}};
          const unsigned int n_x = raster.refinement(0);
          const unsigned int n_y = raster.refinement(1);
          for (unsigned int b = 0; b <= n_y; ++b)
            for (unsigned int a = 0; a <= n_x; ++a)
              {
                const double xi = double(a) / n_x, eta = double(b) / n_y;
                const std::array<double, 4> weights = {{(1. - xi) * (1. - eta),
                                                        xi * (1. - eta),
                                                        (1. - xi) * eta,
                                                        xi * eta}};

                double lack   = raster.height(i * n_x + a, j * n_y + b);
                double square = 0.;
                for (unsigned int v = 0; v < 4; ++v)
                  {
                    lack -= weights[v] * heights[corners[v]];
                    square += weights[v] * weights[v];
                  }
                if (lack > 0.)
                  for (unsigned int v = 0; v < 4; ++v)
                    lifts[corners[v]] =
                      std::max(lifts[corners[v]], lack * weights[v] / square);
              }
        }

        const ColumnGrid   &columns;
        const HeightRaster &raster;
        std::vector<double> heights;
      };



      /** The upper surface, or minus the lower one. */
      std::vector<double>
      pull_over(const ColumnGrid             &columns,
                const std::vector<FiberAxis> &fibers,
                const bool                    upside_down)
      {
        double radius = 0.;
        for (const FiberAxis &fiber : fibers)
          radius = std::max(radius, fiber.radius);
        const HeightRaster raster(columns, fibers, radius, upside_down);

        // Each round of 1-2-1 adds half a column squared to the variance of the
        // weights.
        const double smoothing_length = 3. * radius;
        const auto   n_rounds         = [&](const unsigned int d) {
          return std::clamp<int>(
            std::ceil(2. * std::pow(smoothing_length / columns.size(d), 2.)),
            2,
            500);
        };
        const std::array<int, 2> n      = {{n_rounds(0), n_rounds(1)}};
        const int                n_most = std::max(n[0], n[1]);

        Membrane membrane(columns, raster);
        membrane.fill_holes();
        for (int round = 0; round < n_most; ++round)
          {
            for (unsigned int d = 0; d < 2; ++d)
              if ((round + 1) * n[d] / n_most > round * n[d] / n_most)
                membrane.smooth(d);
            membrane.lift();
          }
        return membrane.result();
      }
    } // namespace



    Envelope
    fabric_envelope(const ColumnGrid             &columns,
                    const std::vector<FiberAxis> &fibers)
    {
      Envelope envelope;
      envelope.upper = pull_over(columns, fibers, /*upside_down=*/false);
      envelope.lower = pull_over(columns, fibers, /*upside_down=*/true);
      for (double &height : envelope.lower)
        height = -height;
      return envelope;
    }
  } // namespace Textile
} // namespace Heddle
