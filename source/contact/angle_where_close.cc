#include <heddle/contact/angle_where_close.h>

#include <algorithm>
#include <cmath>

namespace Heddle
{
  namespace Contact
  {
    namespace
    {
      /** Above this cosine no other place has to be asked. */
      constexpr double clearly_aligned = 0.7;

      /** Distances are about the same if they differ by less, relatively. */
      constexpr double as_close = 0.05;



      /** Cosine of the angle of two curves where they are closest to each
       * other, sought from these intervals. */
      double
      cosine_at_closest(const Curve       &a,
                        const unsigned int i,
                        const Curve       &b,
                        const unsigned int j)
      {
        unsigned int hint_a = i, hint_b = j;
        double       s_a = a.middle(i), s_b = b.middle(j);
        const double scale = a.radius + b.radius;
        const auto   bounded =
          [](const double low, const double value, const double high) {
            return std::min(std::max(value, low), high);
          };
        CurvePoint point_a, point_b;
        for (unsigned int iteration = 0; iteration < 20; ++iteration)
          {
            point_a = a.evaluate(s_a, hint_a);
            point_b = b.evaluate(s_b, hint_b);

            // A step of Gauss and Newton; of parallel fibers none is closest.
            const Tensor<1, 3> connection = point_a.position - point_b.position;
            const double       aa    = 1.01 * point_a.tangent.norm_square(),
                         bb          = 1.01 * point_b.tangent.norm_square(),
                         ab          = point_a.tangent * point_b.tangent,
                         fa          = -(connection * point_a.tangent),
                         fb          = connection * point_b.tangent;
            const double determinant = aa * bb - ab * ab;
            const double largest_step =
              std::max(scale, 0.5 * connection.norm());
            const double step_a = bounded(
              -largest_step, (bb * fa + ab * fb) / determinant, largest_step);
            const double step_b = bounded(
              -largest_step, (ab * fa + aa * fb) / determinant, largest_step);
            s_a = bounded(0., s_a + step_a, a.length());
            s_b = bounded(0., s_b + step_b, b.length());
            if (std::abs(step_a) + std::abs(step_b) < 1e-6 * scale)
              break;
          }
        return point_a.tangent * point_b.tangent;
      }
    } // namespace



    double
    cosine_where_close(const CandidatePair             *pairs,
                       const std::vector<double>       &squared_distances,
                       const std::vector<unsigned int> &zones,
                       const unsigned int               closest,
                       const Curve                     &a,
                       const Curve                     &b)
    {
      const auto cosine_from = [&](const unsigned int k) {
        return cosine_at_closest(
          a, pairs[k].interval_a, b, pairs[k].interval_b);
      };
      const double at_closest = cosine_from(closest);
      if (std::abs(at_closest) > clearly_aligned)
        return at_closest;

      // A thin fiber that lies around a thick one is as close to it in several
      // places, at angles to either side, and chance says which one is the
      // closest. Ranks know different parts of a zone, but all that is this
      // close.
      const double least = std::sqrt(squared_distances[closest]);
      double       sum = at_closest, weights = 1.;
      for (unsigned int k = 0; k < zones.size(); ++k)
        if (zones[k] == zones[closest] && k != closest)
          {
            const double weight =
              1. -
              (std::sqrt(squared_distances[k]) - least) / (as_close * least);
            if (weight > 0.)
              {
                sum += weight * cosine_from(k);
                weights += weight;
              }
          }
      return sum / weights;
    }
  } // namespace Contact
} // namespace Heddle
