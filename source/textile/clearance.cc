#include <heddle/textile/clearance.h>

#include <algorithm>
#include <limits>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      struct Box
      {
        Tensor<1, 3> lowest, highest;

        Box()
        {
          for (unsigned int d = 0; d < 3; ++d)
            {
              lowest[d]  = std::numeric_limits<double>::max();
              highest[d] = -std::numeric_limits<double>::max();
            }
        }

        void
        add(const Tensor<1, 3> &point)
        {
          for (unsigned int d = 0; d < 3; ++d)
            {
              lowest[d]  = std::min(lowest[d], point[d]);
              highest[d] = std::max(highest[d], point[d]);
            }
        }

        bool
        is_near(const Box &other, const double distance) const
        {
          for (unsigned int d = 0; d < 3; ++d)
            if (lowest[d] > other.highest[d] + distance ||
                other.lowest[d] > highest[d] + distance)
              return false;
          return true;
        }
      };



      Box
      box_of_segment(const Polyline &line, const unsigned int segment)
      {
        Box box;
        box.add(line[segment]);
        box.add(line[segment + 1]);
        return box;
      }



      /** Numbers of the segments of @p line nearer to @p box than @p reach. */
      std::vector<unsigned int>
      segments_near(const Polyline &line, const Box &box, const double reach)
      {
        std::vector<unsigned int> segments;
        for (unsigned int s = 0; s + 1 < line.size(); ++s)
          if (box_of_segment(line, s).is_near(box, reach))
            segments.push_back(s);
        return segments;
      }



      /** Distance between the segments [a, b] and [c, d]. */
      double
      segment_distance(const Tensor<1, 3> &a,
                       const Tensor<1, 3> &b,
                       const Tensor<1, 3> &c,
                       const Tensor<1, 3> &d)
      {
        const Tensor<1, 3> u = b - a, v = d - c, w = a - c;
        const double       uu = u * u, vv = v * v, uv = u * v;
        const double       uw = u * w, vw = v * w;
        const double       determinant = uu * vv - uv * uv;

        // The best point of the first line, cut to its segment, then the best
        // of the second for it, then again of the first: exact.
        double       s = determinant > 1e-12 * uu * vv
                           ? std::clamp((uv * vw - vv * uw) / determinant, 0., 1.)
                           : 0.;
        const double t = std::clamp((uv * s + vw) / vv, 0., 1.);
        s              = std::clamp((uv * t - uw) / uu, 0., 1.);
        return (w + s * u - t * v).norm();
      }
    } // namespace



    double
    smallest_distance(const std::vector<Polyline> &first,
                      const std::vector<Polyline> &second,
                      const double                 enough,
                      const double                 too_close)
    {
      std::vector<Box> boxes(second.size());
      for (unsigned int j = 0; j < second.size(); ++j)
        for (const Tensor<1, 3> &point : second[j])
          boxes[j].add(point);

      double smallest = enough;
      for (const Polyline &a : first)
        for (unsigned int j = 0; j < second.size(); ++j)
          {
            const Polyline &b    = second[j];
            const auto      of_a = segments_near(a, boxes[j], smallest);
            Box             box;
            for (const unsigned int s : of_a)
              {
                box.add(a[s]);
                box.add(a[s + 1]);
              }
            const auto of_b = segments_near(b, box, smallest);
            for (const unsigned int s : of_a)
              for (const unsigned int t : of_b)
                if (box_of_segment(a, s).is_near(box_of_segment(b, t),
                                                 smallest))
                  smallest = std::min(
                    smallest, segment_distance(a[s], a[s + 1], b[t], b[t + 1]));
            if (smallest < too_close)
              return smallest;
          }
      return smallest;
    }
  } // namespace Textile
} // namespace Heddle
