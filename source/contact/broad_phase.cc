#include <heddle/contact/broad_phase.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/numbers.h>
#include <deal.II/boost_adaptors/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>

namespace Heddle
{
  namespace Contact
  {
    namespace internal
    {
      namespace BroadPhase
      {
        struct Interval
        {
          unsigned int curve;
          unsigned int interval;
        };

        using Entry = std::pair<BoundingBox<3>, Interval>;

        /** The box of the control points of one cubic, grown by @p margin. */
        BoundingBox<3>
        box(const Curve &curve, const unsigned int i, const double margin)
        {
          const double h = curve.arc_lengths[i + 1] - curve.arc_lengths[i];
          const Tensor<1, 3> control[4] = {
            curve.positions[i],
            curve.positions[i] + h / 3. * curve.tangents[i],
            curve.positions[i + 1] - h / 3. * curve.tangents[i + 1],
            curve.positions[i + 1]};
          Point<3> low, high;
          for (unsigned int d = 0; d < 3; ++d)
            {
              low[d] = std::min({control[0][d],
                                 control[1][d],
                                 control[2][d],
                                 control[3][d]}) -
                       margin;
              high[d] = std::max({control[0][d],
                                  control[1][d],
                                  control[2][d],
                                  control[3][d]}) +
                        margin;
            }
          return BoundingBox<3>({low, high});
        }



        bool
        may_touch(const NumberedCurve &a,
                  const unsigned int   i,
                  const NumberedCurve &b,
                  const unsigned int   j)
        {
          if (!a.own && !b.own)
            return false;
          // Two that are stale find each other twice.
          if (a.fiber != b.fiber)
            return a.fiber < b.fiber || !b.stale;
          return i < j && a.curve.arc_lengths[j + 1] - a.curve.arc_lengths[i] >
                            least_self_separation(a.curve);
        }
      } // namespace BroadPhase
    }   // namespace internal



    double
    least_self_separation(const Curve &curve)
    {
      return 2. * numbers::PI * curve.radius;
    }



    std::vector<CandidatePair>
    find_candidates(const std::vector<NumberedCurve> &curves,
                    const double                      search_distance)
    {
      using namespace internal::BroadPhase;
      namespace bgi = boost::geometry::index;

      std::vector<Entry> entries;
      for (unsigned int c = 0; c < curves.size(); ++c)
        for (unsigned int i = 0; i + 1 < curves[c].curve.n_knots; ++i)
          entries.emplace_back(
            box(curves[c].curve,
                i,
                curves[c].curve.radius + 0.5 * search_distance),
            Interval{c, i});
      const boost::geometry::index::rtree<Entry, bgi::linear<16>> tree(entries);

      std::vector<CandidatePair> candidates;
      for (const Entry &entry : entries)
        {
          const NumberedCurve &a = curves[entry.second.curve];
          const unsigned int   i = entry.second.interval;
          if (!a.stale)
            continue;
          for (auto hit = tree.qbegin(bgi::intersects(entry.first));
               hit != tree.qend();
               ++hit)
            {
              const NumberedCurve &b = curves[hit->second.curve];
              const unsigned int   j = hit->second.interval;
              if (may_touch(a, i, b, j))
                candidates.push_back(a.fiber <= b.fiber
                                       ? CandidatePair{a.fiber, b.fiber, i, j}
                                       : CandidatePair{b.fiber, a.fiber, j, i});
            }
        }
      std::sort(candidates.begin(), candidates.end());
      return candidates;
    }
  } // namespace Contact
} // namespace Heddle
