#include <heddle/post/centerline.h>
#include <heddle/post/crossing_order.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

namespace Heddle
{
  namespace Post
  {
    namespace
    {
      /** Straight pieces between two nodes. */
      constexpr unsigned int pieces_per_interval = 4;



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



      using Points = std::pair<Tensor<1, 3>, Tensor<1, 3>>;



      /** Where the segment [a, b] passes above or below [c, d]. */
      std::optional<Points>
      where_segments_cross(const Tensor<1, 3> &a,
                           const Tensor<1, 3> &b,
                           const Tensor<1, 3> &c,
                           const Tensor<1, 3> &d)
      {
        const auto cross = [](const Tensor<1, 3> &u, const Tensor<1, 3> &v) {
          return u[0] * v[1] - u[1] * v[0];
        };
        const double determinant = cross(b - a, d - c);
        if (determinant == 0.)
          return {};
        const double s = cross(c - a, d - c) / determinant;
        const double t = cross(c - a, b - a) / determinant;
        if (s < 0. || s > 1. || t < 0. || t > 1.)
          return {};
        return Points(a + s * (b - a), c + t * (d - c));
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
                const auto points = where_segments_cross(
                  upper[s], upper[s + 1], lower[t], lower[t + 1]);
                if (!points)
                  continue;
                if (points->first[2] <= points->second[2])
                  return Order::wrong;
                order = Order::right;
              }
        return order;
      }



      /** Add the pairs of which both lists have a line. */
      void
      add_pairs(const std::vector<Polyline>      &uppers,
                const std::vector<Polyline>      &lowers,
                const std::vector<OrderedFibers> &crossings,
                CrossingCount                    &count)
      {
        for (const OrderedFibers &crossing : crossings)
          for (const unsigned int j : crossing.lower)
            {
              if (lowers[j].empty())
                continue;
              Rectangle around;
              for (const Tensor<1, 3> &point : lowers[j])
                around.add(point);
              for (const unsigned int i : crossing.upper)
                {
                  if (uppers[i].empty())
                    continue;
                  const Order order =
                    order_of_fibers(uppers[i], lowers[j], around);
                  ++count.total;
                  count.wrong += (order == Order::wrong);
                  count.apart += (order == Order::apart);
                }
            }
      }
    } // namespace



    std::optional<std::pair<Tensor<1, 3>, Tensor<1, 3>>>
    crossing_points(const Polyline &first, const Polyline &second)
    {
      Rectangle around_second;
      for (const Tensor<1, 3> &point : second)
        around_second.add(point);
      for (unsigned int s = 0; s + 1 < first.size(); ++s)
        if (around_second.meets_segment(first, s))
          for (unsigned int t = 0; t + 1 < second.size(); ++t)
            if (const auto points = where_segments_cross(
                  first[s], first[s + 1], second[t], second[t + 1]))
              return points;
      return {};
    }



    std::string
    CrossingCount::wrong_in_words() const
    {
      if (wrong == 0)
        return "";
      return std::to_string(wrong) + " of " + std::to_string(total) +
             " crossings of fibers are not as the pattern wants them";
    }



    std::string
    CrossingCount::apart_in_words() const
    {
      if (apart == 0)
        return "";
      return std::to_string(apart) + " of " + std::to_string(total) +
             " pairs of fibers do not cross though the pattern wants it";
    }



    CrossingCount
    count_crossing_order(const std::vector<Polyline>      &fibers,
                         const std::vector<OrderedFibers> &crossings)
    {
      CrossingCount count;
      add_pairs(fibers, fibers, crossings, count);
      return count;
    }



    CrossingCount
    count_crossing_order(const System::State              &state,
                         const std::vector<OrderedFibers> &crossings,
                         const PointMap                   &flattened)
    {
      const MPI_Comm        communicator = state.space.communicator();
      const auto            range        = state.space.owned_fibers();
      std::vector<Polyline> own(state.space.n_fibers());
      for (unsigned int f = range.first; f < range.second; ++f)
        {
          own[f] = centerline(state, f, pieces_per_interval);
          move_points(own[f], flattened);
        }

      CrossingCount      count;
      const unsigned int n_ranks =
        Utilities::MPI::n_mpi_processes(communicator);
      for (unsigned int rank = 0; rank < n_ranks; ++rank)
        add_pairs(own,
                  Utilities::MPI::broadcast(communicator, own, rank),
                  crossings,
                  count);
      count.total = Utilities::MPI::sum(count.total, communicator);
      count.wrong = Utilities::MPI::sum(count.wrong, communicator);
      count.apart = Utilities::MPI::sum(count.apart, communicator);
      return count;
    }
  } // namespace Post
} // namespace Heddle
