#include <heddle/base/exceptions.h>
#include <heddle/textile/check_paths.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/boost_adaptors/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <optional>
#include <sstream>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      /** Axes closer to each other than this part of the radius are one. */
      constexpr double same_axis = 1e-3;

      /** Least part of the shorter of two segments that the other one covers:
       * two fibers may follow each other. */
      constexpr double least_overlap = 0.01;

      /** The straight line between two points of a path. */
      struct Segment
      {
        unsigned int fiber;
        Tensor<1, 3> begin, end; /**< [mm] */
      };

      using Entry = std::pair<BoundingBox<3>, unsigned int>;



      BoundingBox<3>
      box(const Segment &segment, const double margin)
      {
        Point<3> low, high;
        for (unsigned int d = 0; d < 3; ++d)
          {
            low[d]  = std::min(segment.begin[d], segment.end[d]) - margin;
            high[d] = std::max(segment.begin[d], segment.end[d]) + margin;
          }
        return BoundingBox<3>({low, high});
      }



      /**
       * Return the middle of the stretch along which @p a and @p b are side by
       * side if they lie within @p tolerance of each other there. Distances of
       * straight lines are largest at the ends of it.
       */
      std::optional<Tensor<1, 3>>
      middle_of_overlap(const Segment &a,
                        const Segment &b,
                        const double   tolerance)
      {
        const Tensor<1, 3> along_a = a.end - a.begin, along_b = b.end - b.begin;
        const double       squared_length = along_a.norm_square();
        const double from = (b.begin - a.begin) * along_a / squared_length,
                     to   = (b.end - a.begin) * along_a / squared_length;
        if (from == to)
          return {};
        const auto distance = [&](const double t) {
          const double u = (t - from) / (to - from);
          return (a.begin + t * along_a - b.begin - u * along_b).norm();
        };
        const double begin = std::clamp(std::min(from, to), 0., 1.),
                     end   = std::clamp(std::max(from, to), 0., 1.);
        const double shorter =
          std::min(1., std::sqrt(along_b.norm_square() / squared_length));
        if (end - begin <= least_overlap * shorter ||
            distance(begin) >= tolerance || distance(end) >= tolerance)
          return {};
        return a.begin + 0.5 * (begin + end) * along_a;
      }



      [[noreturn]] void
      refuse(const unsigned int  fiber,
             const unsigned int  other,
             const Tensor<1, 3> &place)
      {
        std::ostringstream text;
        text << std::setprecision(3) << "Fibers " << fiber << " and " << other
             << " (from 0) lie in the same place near (" << place[0] << ", "
             << place[1] << ", " << place[2]
             << "): remove one of them or, in a weave, raise the spacing of "
                "yarns or fibers.";
        throw InputError(text.str());
      }
    } // namespace



    void
    check_paths(const std::vector<FiberPath> &paths)
    {
      std::vector<Segment> segments;
      std::vector<Entry>   entries;
      for (unsigned int f = 0; f < paths.size(); ++f)
        for (std::size_t i = 0; i + 1 < paths[f].points.size(); ++i)
          {
            segments.push_back({f, paths[f].points[i], paths[f].points[i + 1]});
            entries.push_back(
              {box(segments.back(), same_axis * paths[f].radius),
               static_cast<unsigned int>(segments.size() - 1)});
          }
      const RTree<Entry> tree = pack_rtree(entries);
      for (const auto &[around, number] : entries)
        {
          const Segment &a = segments[number];
          for (auto found =
                 tree.qbegin(boost::geometry::index::intersects(around));
               found != tree.qend();
               ++found)
            {
              const Segment &b = segments[found->second];
              if (a.fiber >= b.fiber)
                continue;
              const double radius =
                std::min(paths[a.fiber].radius, paths[b.fiber].radius);
              const auto place = middle_of_overlap(a, b, same_axis * radius);
              if (place)
                refuse(a.fiber, b.fiber, *place);
            }
        }
    }
  } // namespace Textile
} // namespace Heddle
