#include <heddle/base/lanes.h>
#include <heddle/contact/broad_phase.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/exceptions.h>
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

        /**
         * So many intervals that follow each other on a fiber are near the same
         * others, which they look for, and are compared with, at once.
         */
        constexpr unsigned int n_at_once = 4;

        using Wide = Lanes<n_at_once>;

        /** Which of them, as comparisons tell: all bits, or none. */
        using Which = decltype(Wide() < Wide());

        bool
        any(const Which &which)
        {
          bool found = false;
          for (unsigned int k = 0; k < n_at_once; ++k)
            found = found || which[k];
          return found;
        }



        /** The cubic lies no further than its bulge from its chord. */
        template <typename Number>
        struct Chord
        {
          Number begin[3], along[3], bulge; /**< [mm] */
        };

        /**
         * The whole of a cubic, to reject most pairs, and its halves, which
         * lie closer to their chords: long elements of thin fibers bulge by
         * more than fibers are apart.
         */
        template <typename Number>
        struct Bounds
        {
          Chord<Number> whole, first_half, second_half;
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



        Chord<double>
        chord(const ControlPoints &control)
        {
          const Tensor<1, 3> along = control[3] - control[0];
          Chord<double>      result;
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



        Bounds<double>
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
         * The squared distance of chords: where it is least for that of b, held
         * to b, then where it is least on a (C. Ericson, Real-Time Collision
         * Detection, 2005, section 5.1.9).
         */
        class ChordDistance
        {
        public:
          ChordDistance(const Chord<Wide> &a, const Chord<double> &b)
            : a(a)
            , b(b)
          {
            for (unsigned int d = 0; d < 3; ++d)
              {
                const Wide c = a.begin[d] - b.begin[d];
                aa += a.along[d] * a.along[d];
                ab += a.along[d] * b.along[d];
                bb += b.along[d] * b.along[d];
                ac += a.along[d] * c;
                bc += b.along[d] * c;
                cc += c * c;
              }
          }

          /** Set @p square to the least squared distance of their ends. */
          void
          of_ends(Wide &square) const
          {
            const auto take = [&square](const Wide &other) {
              square = other < square ? other : square;
            };
            square = cc;
            take(cc + 2. * ac + aa);
            take(cc - 2. * bc + bb);
            take(cc + 2. * (ac - bc - ab) + aa + bb);
          }

          /** Set @p square to that of the chords. */
          void
          squared(Wide &square) const
          {
            const auto bound = [](Wide &value) {
              value = value < 0. ? Wide{} : value;
              value = value > 1. ? Wide{} + 1. : value;
            };

            // Of parallel chords any place on a is as good.
            const Wide determinant = aa * bb - ab * ab;
            Wide       first       = (ab * bc - ac * bb) / determinant;
            bound(first);
            first  = determinant > 1e-12 * aa * bb ? first : Wide{};
            Wide t = (ab * first + bc) / bb;
            bound(t);
            Wide s = (ab * t - ac) / aa;
            bound(s);
            square = Wide{};
            for (unsigned int d = 0; d < 3; ++d)
              {
                const Wide apart =
                  a.begin[d] + s * a.along[d] - b.begin[d] - t * b.along[d];
                square += apart * apart;
              }
          }

        private:
          const Chord<Wide>   &a;
          const Chord<double> &b;
          Wide                 aa = {}, ab = {}, ac = {}, bc = {}, cc = {};
          double               bb = 0.;
        };



        /** Intervals of one fiber that follow each other, side by side. */
        class Strip
        {
        public:
          /** Of the entries from @p first to @p last, no more than four. */
          Strip(const std::vector<Entry>          &entries,
                const std::vector<Bounds<double>> &bounds,
                const unsigned int                 first,
                const unsigned int                 last)
          {
            for (unsigned int k = 0; k < n_at_once; ++k)
              {
                const unsigned int i = std::min(first + k, last - 1);
                if (k == 0)
                  whole_box = entries[i].first;
                else
                  whole_box.merge_with(entries[i].first);
                for (unsigned int d = 0; d < 3; ++d)
                  {
                    low[d][k]  = entries[i].first.lower_bound(d);
                    high[d][k] = entries[i].first.upper_bound(d);
                  }
                known[k] = first + k < last ? -1 : 0;
                set(k, bounds[i].whole, cubics.whole);
                set(k, bounds[i].first_half, cubics.first_half);
                set(k, bounds[i].second_half, cubics.second_half);
              }
          }

          /** The box of all of them. */
          const BoundingBox<3> &
          box() const
          {
            return whole_box;
          }

          /** Set @p which to those whose boxes meet the other one. */
          void
          meet(const BoundingBox<3> &other, Which &which) const
          {
            which = known;
            for (unsigned int d = 0; d < 3; ++d)
              which &= (low[d] <= other.upper_bound(d)) &
                       (high[d] >= other.lower_bound(d));
          }

          /**
           * Leave of @p which those that may come as close to the other cubic
           * as @p distance.
           */
          void
          keep_close(const Bounds<double> &other,
                     const double          distance,
                     Which                &which) const
          {
            // Cubics end where their chords do: most that are close, are so
            // there.
            const ChordDistance of_wholes(cubics.whole, other.whole);
            Wide                square;
            of_wholes.of_ends(square);
            const Which near = which & (square <= Wide{} + distance * distance);
            if (!any(which & ~near))
              return;
            keep_close(of_wholes, cubics.whole, other.whole, distance, which);
            Which halves = near;
            for (const Chord<Wide> *half :
                 {&cubics.first_half, &cubics.second_half})
              for (const Chord<double> *other_half :
                   {&other.first_half, &other.second_half})
                if (any(which & ~halves))
                  {
                    Which close = which;
                    keep_close(ChordDistance(*half, *other_half),
                               *half,
                               *other_half,
                               distance,
                               close);
                    halves |= close;
                  }
            which = halves;
          }

        private:
          static void
          keep_close(const ChordDistance &between,
                     const Chord<Wide>   &chords,
                     const Chord<double> &other,
                     const double         distance,
                     Which               &which)
          {
            Wide square;
            between.squared(square);
            const Wide reach = distance + chords.bulge + other.bulge;
            which &= square <= reach * reach;
          }

          static void
          set(const unsigned int k, const Chord<double> &of, Chord<Wide> &all)
          {
            for (unsigned int d = 0; d < 3; ++d)
              {
                all.begin[d][k] = of.begin[d];
                all.along[d][k] = of.along[d];
              }
            all.bulge[k] = of.bulge;
          }

          BoundingBox<3> whole_box;
          Which          known;
          Wide           low[3], high[3];
          Bounds<Wide>   cubics;
        };



        /**
         * Leave of @p which, from interval @p i of a fiber on, those before
         * interval @p j between which and that there is more than @p window of
         * the arc.
         */
        void
        keep_apart(const Curve       &curve,
                   const unsigned int i,
                   const unsigned int j,
                   const double       window,
                   Which             &which)
        {
          for (unsigned int k = 0; k < n_at_once; ++k)
            if (i + k >= j ||
                curve.arc_lengths[j + 1] - curve.arc_lengths[i + k] <= window)
              which[k] = 0;
        }



        /**
         * Visit the pairs of intervals whose surfaces may be closer than
         * @p distance, of a curve that @p begins and another one that it
         * @p meets, or of one with itself where more than @p window of its arc
         * is between, until @p visit says that it has seen enough.
         */
        template <typename Begins, typename Meets, typename Visit>
        void
        visit_close_pairs(const std::vector<NumberedCurve> &curves,
                          const double                      distance,
                          const double                      window,
                          const Begins                     &begins,
                          const Meets                      &meets,
                          const Visit                      &visit)
        {
          namespace bgi = boost::geometry::index;

          std::vector<Entry>          entries;
          std::vector<Bounds<double>> bounds;
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

          unsigned int last = 0;
          for (unsigned int first = 0; first < entries.size(); first = last)
            {
              const unsigned int   c = entries[first].second.curve;
              const unsigned int   i = entries[first].second.interval;
              const NumberedCurve &a = curves[c];
              last = first + std::min(n_at_once, a.curve.known.second - 1 - i);
              if (!begins(a))
                continue;
              const Strip strip(entries, bounds, first, last);
              for (auto hit = tree.qbegin(bgi::intersects(strip.box()));
                   hit != tree.qend();
                   ++hit)
                {
                  const NumberedCurve &b = curves[hit->second.curve];
                  const unsigned int   j = hit->second.interval;
                  if (!meets(a, b))
                    continue;
                  Which which;
                  strip.meet(hit->first, which);
                  if (c == hit->second.curve)
                    keep_apart(a.curve,
                               i,
                               j,
                               std::max(window, least_self_separation(a.curve)),
                               which);
                  if (!any(which))
                    continue;
                  strip.keep_close(bounds[hit->second.bounds],
                                   a.curve.radius + b.curve.radius + distance,
                                   which);
                  for (unsigned int k = 0; k < n_at_once; ++k)
                    if (which[k] && visit(a, i + k, b, j))
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

      Assert(std::is_sorted(curves.begin(),
                            curves.end(),
                            [](const NumberedCurve &a, const NumberedCurve &b) {
                              return a.fiber < b.fiber;
                            }),
             ExcInternalError());

      // As found, pairs of one fiber with those of larger numbers follow each
      // other, so that few are to be sorted at once. Those of smaller numbers,
      // which are not stale, are apart.
      std::vector<CandidatePair> candidates, of_smaller;
      visit_close_pairs(
        curves,
        search_distance,
        /*window=*/0.,
        [](const NumberedCurve &a) { return a.stale; },
        [](const NumberedCurve &a, const NumberedCurve &b) {
          // Two that are stale find each other twice.
          return (a.own || b.own) && (a.fiber <= b.fiber || !b.stale);
        },
        [&](const NumberedCurve &a,
            const unsigned int   i,
            const NumberedCurve &b,
            const unsigned int   j) {
          if (a.fiber <= b.fiber)
            candidates.push_back({a.fiber, b.fiber, i, j});
          else
            of_smaller.push_back({b.fiber, a.fiber, j, i});
          return false;
        });
      for (auto first = candidates.begin(); first != candidates.end();)
        {
          const auto last = std::find_if(
            first, candidates.end(), [first](const CandidatePair &pair) {
              return pair.fiber_a != first->fiber_a;
            });
          std::sort(first, last);
          first = last;
        }
      std::sort(of_smaller.begin(), of_smaller.end());
      const auto middle = candidates.insert(
        candidates.end(), of_smaller.begin(), of_smaller.end());
      std::inplace_merge(candidates.begin(), middle, candidates.end());
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
        window,
        [](const NumberedCurve &) { return true; },
        [](const NumberedCurve &a, const NumberedCurve &b) {
          return a.fiber <= b.fiber;
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
