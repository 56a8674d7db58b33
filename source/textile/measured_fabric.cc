#include <heddle/base/exceptions.h>
#include <heddle/base/yarn_set.h>
#include <heddle/textile/extent.h>
#include <heddle/textile/measured_fabric.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      const std::array<std::string, 2> sets = {
        {word(YarnSet::warp), word(YarnSet::weft)}};

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
       * where to where they reach across it. */
      struct Sum
      {
        double       places   = 0.;
        unsigned int n_fibers = 0;
        Extent       across;
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
        }
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
          const Columns columns = columns_of(yarns_of[d]);
          require(columns.n > 1,
                  name + ": there is " +
                    (yarns_of[d].size() == 1 ? "a single yarn"
                                             : "a single stack of yarns") +
                    " of the " + sets[d] +
                    ", so that the width of the fabric is not known; give "
                    "two or more, or load it as 'centerlines' by supports.");
          result[d] = columns.n * columns.spacing();
        }
      return result;
    }
  } // namespace Textile
} // namespace Heddle
