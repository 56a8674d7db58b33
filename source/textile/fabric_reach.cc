#include <heddle/textile/fabric_reach.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      /** Yarns, and fibers that belong to none. */
      std::vector<std::vector<FiberAxis>>
      strands_of(const std::vector<FiberAxis> &fibers)
      {
        std::vector<std::vector<FiberAxis>>            strands;
        std::map<unsigned int, std::vector<FiberAxis>> yarns;
        for (const FiberAxis &fiber : fibers)
          if (fiber.yarn_id == no_id)
            strands.push_back({fiber});
          else
            yarns[fiber.yarn_id].push_back(fiber);
        for (const auto &yarn : yarns)
          strands.push_back(yarn.second);
        return strands;
      }



      /** Mean of the first or the last points of all fibers. */
      Tensor<1, 3>
      end_of(const std::vector<FiberAxis> &strand, const unsigned int which)
      {
        Tensor<1, 3> sum;
        for (const FiberAxis &fiber : strand)
          sum += which == 0 ? fiber.points.front() : fiber.points.back();
        return sum / double(strand.size());
      }



      /** A ring, whose ends are in one place, runs along no axis. */
      bool
      runs_along(const Tensor<1, 3> &chord, const unsigned int d)
      {
        return chord[d] != 0. &&
               std::abs(chord[d]) >= std::abs(chord[(d + 1) % 3]) &&
               std::abs(chord[d]) >= std::abs(chord[(d + 2) % 3]);
      }
    } // namespace



    Extent
    extent_of(const std::vector<FiberAxis> &fibers, const unsigned int d)
    {
      Extent extent;
      for (const FiberAxis &fiber : fibers)
        {
          const double beyond =
            runs_along(fiber.points.back() - fiber.points.front(), d)
              ? 0.
              : fiber.radius;
          for (const Tensor<1, 3> &point : fiber.points)
            {
              extent.add(point[d] - beyond);
              extent.add(point[d] + beyond);
            }
        }
      return extent;
    }



    Extent
    reach_along(const std::vector<FiberAxis> &fibers, const unsigned int d)
    {
      Extent across, common;
      std::swap(common.low, common.high);
      bool some_along = false;
      for (const std::vector<FiberAxis> &strand : strands_of(fibers))
        {
          const Tensor<1, 3> begin = end_of(strand, 0), end = end_of(strand, 1);
          const Tensor<1, 3> chord = end - begin;

          // One that runs along z lies across both axes of the rectangle.
          if (runs_along(chord, d))
            {
              some_along  = true;
              common.low  = std::max(common.low, std::min(begin[d], end[d]));
              common.high = std::min(common.high, std::max(begin[d], end[d]));
            }
          else
            {
              const Extent width = extent_of(strand, d);
              across.add(width.low);
              across.add(width.high);
            }
        }
      return some_along ? Extent{std::min(common.low, across.low),
                                 std::max(common.high, across.high)}
                        : across;
    }
  } // namespace Textile
} // namespace Heddle
