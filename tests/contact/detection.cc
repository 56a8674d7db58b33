// No pair of intervals that dense sampling finds within the search distance is
// missed, and the candidates are not many more than those.
#include <heddle/contact/broad_phase.h>

#include "../tests.h"
#include "knots.h"

#include <algorithm>

using Heddle::Contact::CandidatePair;
using Heddle::Contact::NumberedCurve;

constexpr unsigned int n_fibers  = 24;
constexpr unsigned int n_samples = 24;

/** Least distance of the axes on two intervals, by sampling. */
double
least_distance(const Heddle::Contact::Curve &a,
               const unsigned int            i,
               const Heddle::Contact::Curve &b,
               const unsigned int            j)
{
  const auto sample = [](const Heddle::Contact::Curve &curve,
                         const unsigned int            k) {
    std::vector<Tensor<1, 3>> points;
    unsigned int              hint = k;
    for (unsigned int q = 0; q <= n_samples; ++q)
      points.push_back(
        curve
          .evaluate(curve.arc_lengths[k] +
                      (curve.arc_lengths[k + 1] - curve.arc_lengths[k]) *
                        (q == n_samples ? 1. - 1e-9 : double(q) / n_samples),
                    hint)
          .position);
    return points;
  };
  double least = 1e300;
  for (const auto &x : sample(a, i))
    for (const auto &y : sample(b, j))
      least = std::min(least, (x - y).norm_square());
  return std::sqrt(least);
}



int
main()
{
  initlog();
  // Of three intervals each bends by more than fibers are apart.
  for (const auto &[n_intervals, search_distance] :
       std::vector<std::pair<unsigned int, double>>{
         {9, 0.1}, {9, 1.}, {9, 4.}, {3, 0.1}, {3, 1.}})
    {
      unsigned int n_missed = 0, n_near = 0, n_candidates = 0, n_twice = 0;
      for (unsigned int seed = 0; seed < 5; ++seed)
        {
          RandomNumbers      random(seed);
          std::vector<Knots> knots;
          for (unsigned int f = 0; f < n_fibers; ++f)
            {
              const Tensor<1, 3> along = random.direction();
              const Tensor<1, 3> middle({random.between(-9., 9.),
                                         random.between(-9., 9.),
                                         random.between(-9., 9.)});
              knots.emplace_back(
                wavy_line(middle - 15. * along, along, 30., 5., random),
                n_intervals);
            }
          std::vector<NumberedCurve> curves;
          for (unsigned int f = 0; f < n_fibers; ++f)
            curves.push_back({f, true, knots[f].curve(0.4 + 0.05 * f)});

          const std::vector<CandidatePair> candidates =
            Heddle::Contact::find_candidates(curves, search_distance);
          n_candidates += candidates.size();
          for (unsigned int k = 1; k < candidates.size(); ++k)
            n_twice += candidates[k - 1] < candidates[k] ? 0 : 1;
          for (unsigned int a = 0; a < n_fibers; ++a)
            for (unsigned int b = a; b < n_fibers; ++b)
              for (unsigned int i = 0; i < n_intervals; ++i)
                for (unsigned int j = 0; j < n_intervals; ++j)
                  {
                    const auto &curve_a = curves[a].curve;
                    const auto &curve_b = curves[b].curve;
                    if (a == b &&
                        (i >= j ||
                         curve_a.arc_lengths[j + 1] - curve_a.arc_lengths[i] <
                           Heddle::Contact::least_self_separation(curve_a)))
                      continue;
                    if (least_distance(curve_a, i, curve_b, j) <
                        curve_a.radius + curve_b.radius + search_distance)
                      {
                        ++n_near;
                        n_missed +=
                          std::binary_search(candidates.begin(),
                                             candidates.end(),
                                             CandidatePair{a, b, i, j})
                            ? 0
                            : 1;
                      }
                  }
        }
      deallog << "intervals " << n_intervals << ", search distance "
              << search_distance << ": near " << n_near << ", missed "
              << n_missed << ", found twice " << n_twice
              << ", candidates at most three times as many: "
              << (n_candidates < 3 * n_near ? "yes" : "NO") << std::endl;
    }
}
