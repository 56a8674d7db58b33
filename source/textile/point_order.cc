#include <heddle/textile/point_order.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      /** Cosine of the angle between ways that lie on each other, by a degree.
       */
      constexpr double straight_back = -0.99985;



      /** At which the way is looked at: the first of a fiber, for it takes the
       * square of their number. */
      constexpr unsigned int most_points = 1000;



      /** Length of the way to the nearest point that is left, again and again,
       * from the one that is farthest from the middle [mm]. */
      double
      way_by_nearest(Polyline left)
      {
        Tensor<1, 3> middle;
        for (const Tensor<1, 3> &point : left)
          middle += point / static_cast<double>(left.size());
        unsigned int next = 0;
        for (unsigned int i = 1; i < left.size(); ++i)
          if ((left[i] - middle).norm() > (left[next] - middle).norm())
            next = i;

        double length = 0.;
        while (left.size() > 1)
          {
            const Tensor<1, 3> here = left[next];
            std::swap(left[next], left.back());
            left.pop_back();
            double nearest = std::numeric_limits<double>::max();
            for (unsigned int i = 0; i < left.size(); ++i)
              if ((left[i] - here).norm_square() < nearest)
                {
                  nearest = (left[i] - here).norm_square();
                  next    = i;
                }
            length += std::sqrt(nearest);
          }
        return length;
      }
    } // namespace



    PointOrder
    order_of(const Polyline &points)
    {
      PointOrder order;
      for (unsigned int i = 1; i + 1 < points.size(); ++i)
        order.n_turns +=
          (points[i + 1] - points[i]) * (points[i] - points[i - 1]) < 0.;
      if (order.n_turns == 0 || 4 * order.n_turns + 2 < points.size())
        return order;
      const Polyline first(points.begin(),
                           points.begin() +
                             std::min<std::size_t>(points.size(), most_points));
      double         length = 0.;
      for (unsigned int i = 0; i + 1 < first.size(); ++i)
        length += (first[i + 1] - first[i]).norm();
      order.excess = length / way_by_nearest(first);
      return order;
    }



    unsigned int
    folded_at(const Polyline &points, const double length)
    {
      for (unsigned int i = 1; i + 1 < points.size(); ++i)
        {
          const Tensor<1, 3> before = points[i] - points[i - 1],
                             behind = points[i + 1] - points[i];
          const double shorter      = std::min(before.norm(), behind.norm());
          if (shorter >= length &&
              before * behind < straight_back * before.norm() * behind.norm())
            return i;
        }
      return 0;
    }
  } // namespace Textile
} // namespace Heddle
