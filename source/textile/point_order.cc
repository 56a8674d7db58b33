#include <heddle/textile/point_order.h>

#include <cmath>
#include <limits>
#include <utility>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
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
      double     length = 0.;
      for (unsigned int i = 0; i + 1 < points.size(); ++i)
        {
          const Tensor<1, 3> piece = points[i + 1] - points[i];
          length += piece.norm();
          order.n_turns += i > 0 && piece * (points[i] - points[i - 1]) < 0.;
        }
      if (order.n_turns > 0 && 4 * order.n_turns + 2 >= points.size())
        order.excess = length / way_by_nearest(points);
      return order;
    }
  } // namespace Textile
} // namespace Heddle
