#include <heddle/base/exceptions.h>
#include <heddle/base/yarn_set.h>
#include <heddle/textile/extent.h>
#include <heddle/textile/measured_fabric.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      const std::array<std::string, 2> sets = {
        {word(YarnSet::warp), word(YarnSet::weft)}};

      /** Of a yarn's length, that a fiber should not lack at an end [-]. */
      constexpr double large_part = 0.1;

      /** Yarns that are closer than this, over their width, lie over each other
       * and not side by side [-]. */
      constexpr double stacked = 0.5;

      /** 0 for the warp, which runs along x, 1 for the weft, along y. */
      unsigned int
      direction_of(const FiberPath &path, const std::string &fiber)
      {
        require(path.yarn_id != no_id,
                fiber + " belongs to no yarn; name it in column 'yarn'.");
        const unsigned int d =
          std::find(sets.begin(), sets.end(), path.set) - sets.begin();
        require(d < sets.size(),
                fiber + " belongs to set '" + path.set +
                  "'; in a measured fabric that is 'warp' or 'weft'.");
        const Tensor<1, 3> span = path.points.back() - path.points.front();
        require(std::abs(span[d]) > std::abs(span[1 - d]),
                fiber + " of the " + path.set + " runs along " + "xy"[1 - d] +
                  " and not along " + "xy"[d] +
                  "; turn the fabric, or exchange 'warp' and 'weft'.");
        return d;
      }
    } // namespace



    MeasuredFabric::MeasuredFabric(std::vector<FiberPath> &paths,
                                   const std::string      &name)
      : name(name)
    {
      /** Sum of the places of fibers across their yarn, their number, and from
       * where to where they reach across and along it. */
      struct Sum
      {
        double       places   = 0.;
        unsigned int n_fibers = 0;
        Extent       across;
        double       begin = std::numeric_limits<double>::max();
        double       end   = -std::numeric_limits<double>::max();
      };
      std::array<std::map<unsigned int, Sum>, 2> yarns;
      for (unsigned int f = 0; f < paths.size(); ++f)
        {
          auto              &points = paths[f].points;
          const unsigned int d      = direction_of(
            paths[f],
            name + ": fiber " + std::to_string(f) + " (counted from 0)");
          if (points.back()[d] < points.front()[d])
            std::reverse(points.begin(), points.end());
          Sum         &sum   = yarns[d][paths[f].yarn_id];
          const double place = points[points.size() / 2][1 - d];
          sum.places += place;
          sum.across.add(place - paths[f].radius);
          sum.across.add(place + paths[f].radius);
          ++sum.n_fibers;
          sum.begin = std::min(sum.begin, points.front()[d]);
          sum.end   = std::max(sum.end, points.back()[d]);
        }
      for (unsigned int f = 0; f < paths.size(); ++f)
        {
          const unsigned int d    = paths[f].set == sets[0] ? 0 : 1;
          const Sum         &yarn = yarns[d][paths[f].yarn_id];
          const double       much = large_part * (yarn.end - yarn.begin);
          if (paths[f].points.front()[d] > yarn.begin + much ||
              paths[f].points.back()[d] < yarn.end - much)
            short_ones.push_back(f);
        }
      for (unsigned int d = 0; d < 2; ++d)
        {
          require(!yarns[d].empty(),
                  name + ": there is no " + sets[d] +
                    ", which a measured fabric has; load it as "
                    "'centerlines' by supports.");
          for (const auto &yarn : yarns[d])
            yarns_of[d].push_back(
              {yarn.second.places / yarn.second.n_fibers,
               yarn.second.across.high - yarn.second.across.low});
          std::sort(yarns_of[d].begin(), yarns_of[d].end());
        }
    }



    std::string
    MeasuredFabric::short_fibers() const
    {
      if (short_ones.empty())
        return "";
      return name + ": fiber " + std::to_string(short_ones[0]) +
             " (counted from 0)" +
             (short_ones.size() == 1
                ? " ends"
                : " and " + std::to_string(short_ones.size() - 1) +
                    " others end") +
             " more than a tenth of the yarn's length from its end, but counts "
             "as whole: crimp and volume fraction are wrong, and a load grips "
             "it in the middle of the fabric; trace it to the end, or leave it "
             "out";
    }



    std::array<unsigned int, 2>
    MeasuredFabric::n_yarns() const
    {
      return {{static_cast<unsigned int>(yarns_of[0].size()),
               static_cast<unsigned int>(yarns_of[1].size())}};
    }



    std::array<double, 2>
    MeasuredFabric::width() const
    {
      std::array<double, 2> result;
      for (unsigned int d = 0; d < 2; ++d)
        {
          unsigned int n_columns = 1;
          double       first = yarns_of[d].front().first, last = first;
          for (unsigned int i = 1; i < yarns_of[d].size(); ++i)
            {
              const auto  &yarn = yarns_of[d][i], &before = yarns_of[d][i - 1];
              const double mean_width = 0.5 * (before.second + yarn.second);
              if (yarn.first - before.first > stacked * mean_width)
                {
                  ++n_columns;
                  last = yarn.first;
                }
            }
          require(n_columns > 1,
                  name + ": there is " +
                    (yarns_of[d].size() == 1 ? "a single yarn"
                                             : "a single stack of yarns") +
                    " of the " + sets[d] +
                    ", so that the width of the fabric is not known; give "
                    "two or more, or load it as 'centerlines' by supports.");
          result[d] = n_columns * (last - first) / (n_columns - 1);
        }
      return result;
    }
  } // namespace Textile
} // namespace Heddle
