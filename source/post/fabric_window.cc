#include <heddle/post/fabric_window.h>

#include <algorithm>
#include <cmath>

namespace Heddle
{
  namespace Post
  {
    namespace
    {
      /** Of the angle between two sets of yarns that make a fabric [-]. */
      constexpr double least_sine = 0.2;



      /** z of the vector product: the area in the plane. */
      double
      area_between(const Tensor<1, 3> &a, const Tensor<1, 3> &b)
      {
        return a[0] * b[1] - a[1] * b[0];
      }



      /** Mean of the points of all yarns' mean lines. */
      Tensor<1, 3>
      middle_of(const std::array<std::vector<YarnBody>, 2> &sets)
      {
        Tensor<1, 3> sum;
        double       n = 0.;
        for (const std::vector<YarnBody> &yarns : sets)
          for (const YarnBody &yarn : yarns)
            for (const Tensor<1, 3> &point : yarn.mean)
              {
                sum += point;
                n += 1.;
              }
        return n > 0. ? sum / n : sum;
      }
    } // namespace



    FabricWindow::FabricWindow(const std::array<std::vector<YarnBody>, 2> &sets)
      : origin(middle_of(sets))
    {
      // The ends of yarns may be anywhere: once it is known where yarns cross
      // only what is between counts for how and where they lie.
      for (unsigned int pass = 0; pass < 3; ++pass)
        {
          const std::array<Tensor<1, 3>, 2> along = {
            {mean_direction(sets[0], 0), mean_direction(sets[1], 1)}};
          directions = along;
          sine       = std::abs(area_between(directions[0], directions[1]));
          if (sine < least_sine)
            return;
          const std::array<Columns, 2> across = {
            {find_columns(sets[0], 0), find_columns(sets[1], 1)}};
          columns = across;
        }
      is_found = columns[0].n > 1 && columns[1].n > 1;
    }



    double
    FabricWindow::component(const unsigned int  d,
                            const Tensor<1, 3> &piece) const
    {
      const Tensor<1, 3> &other = directions[1 - d];
      return area_between(piece, other) / area_between(directions[d], other);
    }



    bool
    FabricWindow::is_between(const unsigned int  d,
                             const Tensor<1, 3> &point,
                             const double        margin) const
    {
      const Columns &crossed = columns[1 - d];
      const double   xi      = coordinate(d, point);
      const double   more    = margin / sine;
      return crossed.first - more <= xi && xi <= crossed.last + more;
    }



    bool
    FabricWindow::counts(const unsigned int d, const Tensor<1, 3> &point) const
    {
      return columns[1 - d].n < 2 || is_between(d, point, /*margin=*/0.);
    }



    Tensor<1, 3>
    FabricWindow::mean_direction(const std::vector<YarnBody> &yarns,
                                 const unsigned int           d) const
    {
      Tensor<1, 3> sum;
      for (const YarnBody &yarn : yarns)
        {
          const auto is_in = [this, d](const Tensor<1, 3> &point) {
            return counts(d, point);
          };
          const auto first =
            std::find_if(yarn.mean.begin(), yarn.mean.end(), is_in);
          if (first == yarn.mean.end())
            continue;
          const auto last =
            std::find_if(yarn.mean.rbegin(), yarn.mean.rend(), is_in);
          Tensor<1, 3> span = *last - *first;
          span[2]           = 0.;
          sum += span * sum < 0. ? -span : span;
        }
      return sum.norm() > 0. ? sum / sum.norm() : sum;
    }



    Columns
    FabricWindow::find_columns(const std::vector<YarnBody> &yarns,
                               const unsigned int           d) const
    {
      std::vector<YarnPlace> places;
      for (const YarnBody &yarn : yarns)
        {
          double       sum = 0.;
          unsigned int n   = 0;
          for (const Tensor<1, 3> &point : yarn.mean)
            if (counts(d, point))
              {
                sum += coordinate(1 - d, point);
                ++n;
              }
          if (n == 0)
            continue;
          double low = 0., high = 0.;
          for (unsigned int f = 0; f < yarn.lines.size(); ++f)
            {
              const double middle =
                coordinate(1 - d, yarn.lines[f][yarn.lines[f].size() / 2]);
              const double half = yarn.radii[f] / sine;
              low  = f == 0 ? middle - half : std::min(low, middle - half);
              high = f == 0 ? middle + half : std::max(high, middle + half);
            }
          places.push_back({sum / n, high - low});
        }
      return columns_of(places);
    }



    std::pair<double, double>
    FabricWindow::part_between(const unsigned int  d,
                               const Tensor<1, 3> &a,
                               const Tensor<1, 3> &b) const
    {
      const double begin = coordinate(d, a), end = coordinate(d, b);
      const double low = columns[1 - d].first, high = columns[1 - d].last;
      if (begin == end)
        return {0., low <= begin && begin <= high ? 1. : 0.};
      const double at_low  = (low - begin) / (end - begin);
      const double at_high = (high - begin) / (end - begin);
      return {std::max(0., std::min(at_low, at_high)),
              std::min(1., std::max(at_low, at_high))};
    }
  } // namespace Post
} // namespace Heddle
