#include <heddle/contact/angle_where_close.h>
#include <heddle/contact/proximity_zone.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace Heddle
{
  namespace Contact
  {
    namespace internal
    {
      namespace ProximityZone
      {
        /** Cosine of the angle of two intervals, by their chords. */
        double
        cosine(const Curve       &a,
               const unsigned int i,
               const Curve       &b,
               const unsigned int j)
        {
          const Tensor<1, 3> u = a.position(i + 1) - a.position(i);
          const Tensor<1, 3> v = b.position(j + 1) - b.position(j);
          return u * v / (u.norm() * v.norm());
        }



        /**
         * Below this cosine fibers keep the orientation that they have. In that
         * one fibers turn towards the other one, for their energy falls.
         */
        constexpr double right_angle = 0.1;

        /** Axes closer than this, in sums of radii, are in one place. */
        constexpr double coincident = 1e-3;



        /** Squared distance of the middles of two intervals. */
        double
        squared_distance(const Curve       &a,
                         const unsigned int i,
                         const Curve       &b,
                         const unsigned int j)
        {
          unsigned int hint_a = i, hint_b = j;
          return (a.evaluate(a.middle(i), hint_a).position -
                  b.evaluate(b.middle(j), hint_b).position)
            .norm_square();
        }



        /** Number the connected components of the pairs of intervals. */
        std::vector<unsigned int>
        connect(const CandidatePair       *first,
                const unsigned int         n,
                const std::vector<double> &cosines)
        {
          std::vector<unsigned int> parent(n);
          std::iota(parent.begin(), parent.end(), 0);
          const auto root = [&parent](unsigned int i) {
            while (parent[i] != i)
              i = parent[i] = parent[parent[i]];
            return i;
          };

          // Neighbours of (i, j) with smaller numbers: (i, j-1), which comes
          // just before, and (i-1, j-1 to j+1), where the row before has got
          // to. Parts that run clearly opposite ways do not join.
          const auto join = [&](const unsigned int k,
                                const unsigned int other) {
            if (cosines[k] * cosines[other] > -0.1)
              parent[root(k)] = root(other);
          };
          unsigned int row_before = 0;
          for (unsigned int k = 1; k < n; ++k)
            {
              const unsigned int i = first[k].interval_a,
                                 j = first[k].interval_b;
              if (first[k - 1].interval_a == i &&
                  first[k - 1].interval_b + 1 == j)
                join(k, k - 1);
              const auto place = [&](const unsigned int m) {
                return std::make_pair(first[m].interval_a + 1,
                                      first[m].interval_b + 1);
              };
              while (place(row_before) < std::make_pair(i, j))
                ++row_before;
              for (unsigned int m = row_before;
                   m < k && place(m) <= std::make_pair(i, j + 2);
                   ++m)
                join(k, m);
            }
          for (unsigned int k = 0; k < n; ++k)
            parent[k] = root(k);
          return parent;
        }
      } // namespace ProximityZone
    }   // namespace internal



    double
    ProximityZone::guess(const double p) const
    {
      // The nearest sample that is also close in p: distance along the zone
      // counts like distance across, so that those further along need not be
      // looked at.
      double     best = std::numeric_limits<double>::max(), q = 0.;
      const auto consider = [&](const Sample &sample) {
        const double along  = 0.5 * (sample.p - p);
        const double square = along * along;
        if (sample.squared_distance + square < best)
          {
            best = sample.squared_distance + square;
            q    = sample.q;
          }
        return square < best;
      };
      const auto here = std::lower_bound(
        samples.begin(),
        samples.end(),
        p,
        [](const Sample &sample, const double p) { return sample.p < p; });
      for (auto sample = here; sample != samples.end(); ++sample)
        if (!consider(*sample))
          break;
      for (auto sample = here; sample != samples.begin();)
        if (!consider(*--sample))
          break;
      return q;
    }



    std::pair<double, double>
    ProximityZone::closest() const
    {
      const Sample &sample = *std::min_element(
        samples.begin(),
        samples.end(),
        [](const Sample &left, const Sample &right) {
          return left.squared_distance < right.squared_distance;
        });
      return {0.5 * (sample.p + sample.q),
              0.5 * orientation * (sample.p - sample.q)};
    }



    std::vector<ProximityZone>
    find_zones(const CandidatePair    *first,
               const CandidatePair    *last,
               const Curve            &a,
               const Curve            &b,
               const KnownOrientation &known)
    {
      const unsigned int  n = last - first;
      std::vector<double> cosines(n), squares(n);
      for (unsigned int k = 0; k < n; ++k)
        {
          const unsigned int i = first[k].interval_a, j = first[k].interval_b;
          cosines[k] = internal::ProximityZone::cosine(a, i, b, j);
          squares[k] = internal::ProximityZone::squared_distance(a, i, b, j);
        }
      const std::vector<unsigned int> component =
        internal::ProximityZone::connect(first, n, cosines);

      const double least_weighed = std::pow(
        internal::ProximityZone::coincident * (a.radius + b.radius), 4);
      std::vector<ProximityZone> zones;
      for (unsigned int c = 0; c < n; ++c)
        if (component[c] == c)
          {
            ProximityZone zone;
            zone.fiber_a = first->fiber_a;
            zone.fiber_b = first->fiber_b;

            double       sine_sum = 0., weight_sum = 0., least = 0.;
            unsigned int closest = c;
            for (unsigned int k = 0; k < n; ++k)
              if (component[k] == c)
                {
                  const double square = squares[k];
                  if (weight_sum == 0. || square < least)
                    {
                      least   = square;
                      closest = k;
                    }
                  // Neighbours along a bent zone are at an angle, but apart.
                  // Two axes may have a point in common.
                  const double weight =
                    1. / std::max(square * square, least_weighed);
                  sine_sum +=
                    weight *
                    std::sqrt(std::max(0., 1. - cosines[k] * cosines[k]));
                  weight_sum += weight;
                }
            // At a right angle both orientations give the same forces. The
            // angle is to be told where the fibers touch.
            const double cosine =
              cosine_where_close(first, squares, component, closest, a, b);
            zone.orientation = cosine >= 0. ? 1 : -1;
            if (std::abs(cosine) < internal::ProximityZone::right_angle)
              {
                const int before = known(a.middle(first[closest].interval_a),
                                         b.middle(first[closest].interval_b));
                if (before != 0)
                  zone.orientation = before;
              }
            zone.cosine = zone.orientation * cosine;
            zone.sine   = sine_sum / weight_sum;

            zone.begin = std::numeric_limits<double>::max();
            zone.end   = -zone.begin;
            for (unsigned int k = 0; k < n; ++k)
              if (component[k] == c)
                {
                  const unsigned int i = first[k].interval_a,
                                     j = first[k].interval_b;
                  const double sigma   = zone.orientation;
                  const double s_a     = a.middle(i);
                  const double s_b     = b.middle(j);
                  const double half =
                    a.arc_lengths[i + 1] - s_a + b.arc_lengths[j + 1] - s_b;
                  const double p = s_a + sigma * s_b;
                  zone.begin     = std::min(zone.begin, p - half);
                  zone.end       = std::max(zone.end, p + half);

                  zone.samples.push_back({p, s_a - sigma * s_b, squares[k]});
                }
            std::sort(zone.samples.begin(),
                      zone.samples.end(),
                      [](const ProximityZone::Sample &left,
                         const ProximityZone::Sample &right) {
                        return std::tie(left.p, left.q) <
                               std::tie(right.p, right.q);
                      });
            zones.push_back(zone);
          }
      return zones;
    }
  } // namespace Contact
} // namespace Heddle
