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
          unsigned int bounds;
        };

        /** The cubic lies no further than its bulge from its chord. */
        struct Chord
        {
          double begin[3], along[3], bulge; /**< [mm] */
        };

        /**
         * The whole of a cubic, to reject most pairs, and its halves, which
         * lie closer to their chords: long elements of thin fibers bulge by
         * more than fibers are apart.
         */
        struct Bounds
        {
          Chord whole, first_half, second_half;
        };

        using Entry = std::pair<BoundingBox<3>, Interval>;

        /** The box of the control points, grown by @p margin. */
        BoundingBox<3>
        box(const ControlPoints &control, const double margin)
        {
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



        Chord
        chord(const ControlPoints &control)
        {
          const Tensor<1, 3> along = control[3] - control[0];
          Chord              result;
          result.bulge = 0.;
          for (const unsigned int k : {1, 2})
            {
              const Tensor<1, 3> offset = control[k] - control[0];
              const double       t =
                std::clamp((offset * along) / along.norm_square(), 0., 1.);
              result.bulge =
                std::max(result.bulge, (offset - t * along).norm());
            }
          for (unsigned int d = 0; d < 3; ++d)
            {
              result.begin[d] = control[0][d];
              result.along[d] = along[d];
            }
          return result;
        }



        Bounds
        bound(const ControlPoints &control)
        {
          // P. de Casteljau (1959): means of means are the halves' points.
          const Tensor<1, 3> middle = 0.5 * (control[1] + control[2]);
          ControlPoints      first = control, second = control;
          first[1]  = 0.5 * (control[0] + control[1]);
          first[2]  = 0.5 * (first[1] + middle);
          second[2] = 0.5 * (control[2] + control[3]);
          second[1] = 0.5 * (middle + second[2]);
          first[3] = second[0] = 0.5 * (first[2] + second[1]);
          return {chord(control), chord(first), chord(second)};
        }



        /**
         * Squared distance of two chords: where it is least for that of b, held
         * to b, then where it is least on a (C. Ericson, Real-Time Collision
         * Detection, 2005, section 5.1.9).
         */
        double
        squared_distance(const Chord &a, const Chord &b)
        {
          double aa = 0., ab = 0., bb = 0., ac = 0., bc = 0.;
          for (unsigned int d = 0; d < 3; ++d)
            {
              const double c = a.begin[d] - b.begin[d];
              aa += a.along[d] * a.along[d];
              ab += a.along[d] * b.along[d];
              bb += b.along[d] * b.along[d];
              ac += a.along[d] * c;
              bc += b.along[d] * c;
            }
          const auto bounded = [](const double value) {
            return std::min(std::max(value, 0.), 1.);
          };

          // Of parallel chords any place on a is as good.
          const double determinant = aa * bb - ab * ab;
          const double first       = determinant > 1e-12 * aa * bb
                                       ? bounded((ab * bc - ac * bb) / determinant)
                                       : 0.;
          const double t           = bounded((ab * first + bc) / bb);
          const double s           = bounded((ab * t - ac) / aa);
          double       square      = 0.;
          for (unsigned int d = 0; d < 3; ++d)
            {
              const double apart =
                a.begin[d] + s * a.along[d] - b.begin[d] - t * b.along[d];
              square += apart * apart;
            }
          return square;
        }



        bool
        are_close(const Chord &a, const Chord &b, const double distance)
        {
          const double reach = distance + a.bulge + b.bulge;
          return squared_distance(a, b) <= reach * reach;
        }



        /** Whether two cubics may come as close as @p distance. */
        bool
        are_close(const Bounds &a, const Bounds &b, const double distance)
        {
          return are_close(a.whole, b.whole, distance) &&
                 (are_close(a.first_half, b.first_half, distance) ||
                  are_close(a.second_half, b.second_half, distance) ||
                  are_close(a.first_half, b.second_half, distance) ||
                  are_close(a.second_half, b.first_half, distance));
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



        /**
         * Visit the pairs of intervals whose surfaces may be closer than
         * @p distance, of a curve that @p begins and another one that it
         * @p meets, until @p visit says that it has seen enough.
         */
        template <typename Begins, typename Meets, typename Visit>
        void
        visit_close_pairs(const std::vector<NumberedCurve> &curves,
                          const double                      distance,
                          const Begins                     &begins,
                          const Meets                      &meets,
                          const Visit                      &visit)
        {
          namespace bgi = boost::geometry::index;

          std::vector<Entry>  entries;
          std::vector<Bounds> bounds;
          for (unsigned int c = 0; c < curves.size(); ++c)
            for (unsigned int i = curves[c].curve.known.first;
                 i + 1 < curves[c].curve.known.second;
                 ++i)
              {
                const ControlPoints control =
                  control_points(curves[c].curve, i);
                entries.emplace_back(
                  box(control, curves[c].curve.radius + 0.5 * distance),
                  Interval{c, i, static_cast<unsigned int>(bounds.size())});
                bounds.push_back(bound(control));
              }
          const bgi::rtree<Entry, bgi::linear<16>> tree(entries);

          for (const Entry &entry : entries)
            {
              const NumberedCurve &a = curves[entry.second.curve];
              const unsigned int   i = entry.second.interval;
              if (!begins(a))
                continue;
              for (auto hit = tree.qbegin(bgi::intersects(entry.first));
                   hit != tree.qend();
                   ++hit)
                {
                  const NumberedCurve &b = curves[hit->second.curve];
                  const unsigned int   j = hit->second.interval;
                  if (meets(a, i, b, j) &&
                      are_close(bounds[entry.second.bounds],
                                bounds[hit->second.bounds],
                                a.curve.radius + b.curve.radius + distance) &&
                      visit(a, i, b, j))
                    return;
                }
            }
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

      std::vector<CandidatePair> candidates;
      visit_close_pairs(
        curves,
        search_distance,
        [](const NumberedCurve &a) { return a.stale; },
        may_touch,
        [&](const NumberedCurve &a,
            const unsigned int   i,
            const NumberedCurve &b,
            const unsigned int   j) {
          candidates.push_back(a.fiber <= b.fiber
                                 ? CandidatePair{a.fiber, b.fiber, i, j}
                                 : CandidatePair{b.fiber, a.fiber, j, i});
          return false;
        });
      std::sort(candidates.begin(), candidates.end());
      return candidates;
    }



    bool
    are_apart(const std::vector<NumberedCurve> &curves,
              const double                      distance,
              const double                      window)
    {
      using namespace internal::BroadPhase;

      bool apart = true;
      visit_close_pairs(
        curves,
        distance,
        [](const NumberedCurve &) { return true; },
        [window](const NumberedCurve &a,
                 const unsigned int   i,
                 const NumberedCurve &b,
                 const unsigned int   j) {
          return a.fiber < b.fiber ||
                 (a.fiber == b.fiber && i < j &&
                  a.curve.arc_lengths[j + 1] - a.curve.arc_lengths[i] >
                    std::max(window, least_self_separation(a.curve)));
        },
        [&apart](const NumberedCurve &,
                 const unsigned int,
                 const NumberedCurve &,
                 const unsigned int) {
          apart = false;
          return true;
        });
      return apart;
    }
  } // namespace Contact
} // namespace Heddle
