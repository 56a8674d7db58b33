#include <heddle/base/yarn_reach.h>
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



      /** The ends of a strand: the mean of the fibers that end there. */
      std::array<Tensor<1, 3>, 2>
      ends_of(const std::vector<FiberAxis> &strand)
      {
        std::vector<Polyline> lines;
        for (const FiberAxis &fiber : strand)
          lines.push_back(fiber.points);
        lines = run_one_way(lines);
        const YarnReach             yarn(lines);
        std::array<Tensor<1, 3>, 2> ends;
        for (const unsigned int end : {0, 1})
          {
            double n = 0.;
            for (unsigned int f = 0; f < lines.size(); ++f)
              if (yarn.ends_with_yarn(f)[end])
                {
                  ends[end] += end == 0 ? lines[f].front() : lines[f].back();
                  n += 1.;
                }
            ends[end] /= n;
          }
        return ends;
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
          const auto         ends  = ends_of(strand);
          const Tensor<1, 3> begin = ends[0], end = ends[1];
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
