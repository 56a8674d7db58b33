#include <heddle/post/crossing_order.h>

#include <algorithm>
#include <limits>

namespace Heddle
{
  namespace Post
  {
    namespace
    {
      enum class Order
      {
        right,
        wrong,
        apart
      };



      /** Rectangle in the plane of the fabric. */
      struct Rectangle
      {
        double lowest[2]  = {std::numeric_limits<double>::max(),
                             std::numeric_limits<double>::max()};
        double highest[2] = {-std::numeric_limits<double>::max(),
                             -std::numeric_limits<double>::max()};

        void
        add(const Tensor<1, 3> &point)
        {
          for (unsigned int d = 0; d < 2; ++d)
            {
              lowest[d]  = std::min(lowest[d], point[d]);
              highest[d] = std::max(highest[d], point[d]);
            }
        }

        bool
        meets_segment(const Polyline &line, const unsigned int s) const
        {
          for (unsigned int d = 0; d < 2; ++d)
            if (std::max(line[s][d], line[s + 1][d]) < lowest[d] ||
                std::min(line[s][d], line[s + 1][d]) > highest[d])
              return false;
          return true;
        }
      };



      /** Order of two segments [a, b] above [c, d]. */
      Order
      order_of_segments(const Tensor<1, 3> &a,
                        const Tensor<1, 3> &b,
                        const Tensor<1, 3> &c,
                        const Tensor<1, 3> &d)
      {
        const auto cross = [](const Tensor<1, 3> &u, const Tensor<1, 3> &v) {
          return u[0] * v[1] - u[1] * v[0];
        };
        const double determinant = cross(b - a, d - c);
        if (determinant == 0.)
          return Order::apart;
        const double s = cross(c - a, d - c) / determinant;
        const double t = cross(c - a, b - a) / determinant;
        if (s < 0. || s > 1. || t < 0. || t > 1.)
          return Order::apart;
        return a[2] + s * (b[2] - a[2]) > c[2] + t * (d[2] - c[2])
                 ? Order::right
                 : Order::wrong;
      }



      Order
      order_of_fibers(const Polyline  &upper,
                      const Polyline  &lower,
                      const Rectangle &around_lower)
      {
        // The piece of each fiber that lies in the rectangle of the other one
        // is all that can cross it, and it is short.
        std::vector<unsigned int> upper_segments;
        Rectangle                 piece;
        for (unsigned int s = 0; s + 1 < upper.size(); ++s)
          if (around_lower.meets_segment(upper, s))
            {
              upper_segments.push_back(s);
              piece.add(upper[s]);
              piece.add(upper[s + 1]);
            }

        Order order = Order::apart;
        for (unsigned int t = 0; t + 1 < lower.size(); ++t)
          if (piece.meets_segment(lower, t))
            for (const unsigned int s : upper_segments)
              {
                const Order found = order_of_segments(
                  upper[s], upper[s + 1], lower[t], lower[t + 1]);
                if (found == Order::wrong)
                  return found;
                if (found == Order::right)
                  order = found;
              }
        return order;
      }
    } // namespace



    CrossingCount
    count_crossing_order(const std::vector<Polyline>      &fibers,
                         const std::vector<OrderedFibers> &crossings)
    {
      CrossingCount count;
      for (const OrderedFibers &crossing : crossings)
        for (const unsigned int j : crossing.lower)
          {
            Rectangle around;
            for (const Tensor<1, 3> &point : fibers[j])
              around.add(point);
            for (const unsigned int i : crossing.upper)
              {
                const Order order =
                  order_of_fibers(fibers[i], fibers[j], around);
                ++count.total;
                count.wrong += (order == Order::wrong);
                count.apart += (order == Order::apart);
              }
          }
      return count;
    }
  } // namespace Post
} // namespace Heddle
