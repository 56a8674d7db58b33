// Contact is found wherever it is, and no search that saves time finds anything
// else.
#include <heddle/contact/broad_phase.h>

#include "../tests.h"
#include "knots.h"
#include "random_fibers.h"

#include <algorithm>

using Heddle::Contact::CandidatePair;
using Heddle::Contact::ContactCells;
using Heddle::Contact::ContactElement;
using Heddle::Contact::NumberedCurve;

constexpr unsigned int n_sampled_fibers = 24;
constexpr unsigned int n_samples        = 24;

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



/** Somewhere in a cube, in any direction, with high waves. */
Knots
wavy_fiber(const unsigned int n_intervals, RandomNumbers &random)
{
  const Tensor<1, 3> along = random.direction();
  const Tensor<1, 3> middle({random.between(-9., 9.),
                             random.between(-9., 9.),
                             random.between(-9., 9.)});
  return Knots(wavy_line(middle - 15. * along, along, 30., 5., random),
               n_intervals);
}



/**
 * No pair of intervals that dense sampling finds within the search distance is
 * missed, and the candidates are not many more than those.
 */
void
candidates()
{
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
          for (unsigned int f = 0; f < n_sampled_fibers; ++f)
            knots.push_back(wavy_fiber(n_intervals, random));
          std::vector<NumberedCurve> curves;
          for (unsigned int f = 0; f < n_sampled_fibers; ++f)
            curves.push_back({f, true, knots[f].curve(0.4 + 0.05 * f)});

          const std::vector<CandidatePair> pairs =
            Heddle::Contact::find_candidates(curves, search_distance);
          n_candidates += pairs.size();
          for (unsigned int k = 1; k < pairs.size(); ++k)
            n_twice += pairs[k - 1] < pairs[k] ? 0 : 1;
          for (unsigned int a = 0; a < n_sampled_fibers; ++a)
            for (unsigned int b = a; b < n_sampled_fibers; ++b)
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
                          std::binary_search(pairs.begin(),
                                             pairs.end(),
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



/** Of all fibers that are searched and moved. */
constexpr unsigned int n_fibers  = 30;
constexpr double       threshold = 0.05, skin = 0.05;

/** How many contact elements differ with what is passed over, of how many. */
struct PassedOver
{
  unsigned int elements = 0, wrong = 0, near_cells = 0, cells = 0;
};



void
compare_passed_over(const unsigned int seed,
                    const double       motion,
                    PassedOver        &count)
{
  RandomNumbers             random(seed);
  std::vector<Tensor<1, 3>> directions;
  for (unsigned int k = 0; k < 3; ++k)
    directions.push_back(random.direction());
  std::vector<Knots> knots =
    random_fibers(n_fibers, directions, /*height=*/2., random);
  ContactCells cells(/*search_distance=*/2.,
                     /*refinement=*/2.,
                     [](unsigned int, unsigned int) { return 1.; });
  cells.search(curves_of(knots),
               std::vector<double>(knots.size(), 0.),
               [](unsigned int, unsigned int) { return true; });

  std::vector<double> moved(n_fibers), far(n_fibers, 1e300);
  for (unsigned int f = 0; f < n_fibers; ++f)
    {
      moved[f]                 = random.between(0., motion);
      const Tensor<1, 3> shift = moved[f] * random.direction();
      for (Tensor<1, 3> &position : knots[f].positions)
        position += shift;
    }
  const auto                  curves = curves_of(knots);
  std::vector<ContactElement> elements, all;
  cells.place_elements(curves, moved, threshold, skin, elements);
  cells.place_elements(curves, far, threshold, skin, all);
  for (const auto &cell : cells.cells())
    count.near_cells += cell.clearance <= skin + motion ? 1 : 0;
  count.cells += cells.cells().size();
  count.elements += all.size();
  count.wrong += elements.size() == all.size() ? 0 : 1;
  for (unsigned int k = 0; k < std::min(elements.size(), all.size()); ++k)
    if (elements[k].cell != all[k].cell ||
        std::abs(elements[k].gap - all[k].gap) > 1e-12 ||
        std::abs(elements[k].s_a - all[k].s_a) > 1e-8)
      ++count.wrong;
}



/**
 * Cells that were too far from contact at the search are passed over while
 * fibers move: the elements are the same as without that, near ends, along
 * parallel fibers and at crossings, of a fiber with itself too.
 */
void
passed_over()
{
  for (const double motion : {0., 0.25, 1.})
    {
      PassedOver count;
      for (unsigned int seed = 0; seed < 40; ++seed)
        compare_passed_over(seed, motion, count);
      deallog << "motion " << motion << ": more than 1000 elements: "
              << (count.elements > 1000 ? "yes" : "NO") << ", wrong "
              << count.wrong << ", cells passed over: "
              << (count.near_cells < 0.7 * count.cells ? "many" : "FEW")
              << std::endl;
    }
}



constexpr unsigned int n_rounds = 8;

/** As far as a fiber may have moved without being searched anew. */
constexpr double stale = 0.6;

/** Elements that differ, of how many, and fibers that were searched anew. */
struct SearchedAnew
{
  unsigned int elements = 0, wrong = 0, searched = 0, fibers = 0;
};



void
compare_searched_anew(const unsigned int seed,
                      const double       motion,
                      SearchedAnew      &count)
{
  // Bent as little as fibers that face each other in one place, and not at a
  // right angle: there, and on what faces what, an older search may be of
  // another opinion.
  RandomNumbers             random(seed);
  std::vector<Knots>        knots = random_fibers(n_fibers,
                                           {Tensor<1, 3>({1., 0., 0.}),
                                                   Tensor<1, 3>({0.8, 0.6, 0.}),
                                                   Tensor<1, 3>({-0.8, 0., 0.6})},
                                           /*height=*/0.4,
                                           random);
  const ContactCells        none(/*search_distance=*/3.5,
                          /*refinement=*/2.,
                          [](unsigned int, unsigned int) { return 1.; });
  ContactCells              in_part = none, whole = none;
  const std::vector<double> at_rest(n_fibers, 0.), far(n_fibers, 1e300);
  std::vector<double>       moved(at_rest);
  const auto all = [](unsigned int, unsigned int) { return true; };
  in_part.search(curves_of(knots), moved, all);

  for (unsigned int round = 0; round < n_rounds; ++round)
    {
      for (unsigned int f = 0; f < n_fibers; ++f)
        {
          const double       length = random.between(0., motion);
          const Tensor<1, 3> shift  = length * random.direction();
          for (Tensor<1, 3> &position : knots[f].positions)
            position += shift;
          moved[f] += length;
        }
      const auto                 curves = curves_of(knots);
      Heddle::Contact::CurveList marked;
      marked.reset(n_fibers);
      for (unsigned int f = 0; f < n_fibers; ++f)
        {
          const bool is_stale = moved[f] > stale;
          marked.add({f, true, curves[f], is_stale});
          moved[f] = is_stale ? 0. : moved[f];
          count.searched += is_stale ? 1 : 0;
        }
      count.fibers += n_fibers;
      in_part.search(marked, moved, all);
      whole.search(curves, at_rest, all);

      std::vector<ContactElement> found, known;
      in_part.place_elements(curves, moved, threshold, skin, found);
      whole.place_elements(curves, far, threshold, skin, known);
      count.elements += known.size();
      count.wrong += found.size() == known.size() ? 0 : 1;
      for (unsigned int k = 0; k < std::min(found.size(), known.size()); ++k)
        if (found[k].fiber_a != known[k].fiber_a ||
            found[k].fiber_b != known[k].fiber_b ||
            std::abs(found[k].gap - known[k].gap) > 1e-9 ||
            std::abs(found[k].s_a - known[k].s_a) > 1e-8)
          ++count.wrong;
    }
}



/**
 * Only fibers that moved far are searched anew, again and again: the elements
 * are those of a search of all.
 */
void
searched_in_part()
{
  for (const double motion : {0.1, 0.3, 0.8})
    {
      SearchedAnew count;
      for (unsigned int seed = 0; seed < 15; ++seed)
        compare_searched_anew(seed, motion, count);
      deallog << "motion " << motion << ": more than 1000 elements: "
              << (count.elements > 1000 ? "yes" : "NO") << ", wrong "
              << count.wrong << ", some searched anew, not all: "
              << (count.searched > 0 && count.searched < count.fibers ? "yes"
                                                                      : "NO")
              << std::endl;
    }
}



/**
 * Fibers are apart as far as no candidates are found, with all parts of their
 * arcs; with long ones left out, as far as none is found of two fibers or of
 * such parts.
 */
void
apart()
{
  unsigned int n_apart = 0, n_wrong = 0, n_more = 0;
  for (unsigned int seed = 0; seed < 100; ++seed)
    {
      RandomNumbers      random(seed);
      std::vector<Knots> knots;
      for (unsigned int f = 0; f < 2; ++f)
        knots.push_back(wavy_fiber(/*n_intervals=*/9, random));
      std::vector<NumberedCurve> curves;
      for (unsigned int f = 0; f < 2; ++f)
        curves.push_back({f, true, knots[f].curve(0.2)});
      const double distance = random.between(0.1, 4.);
      for (const double window : {0., 8., 1e300})
        {
          const auto pairs = Heddle::Contact::find_candidates(curves, distance);
          const bool none =
            std::none_of(pairs.begin(), pairs.end(), [&](const auto &pair) {
              const auto &arc = curves[pair.fiber_a].curve.arc_lengths;
              return pair.fiber_a != pair.fiber_b ||
                     arc[pair.interval_b + 1] - arc[pair.interval_a] > window;
            });
          // Fibers that are not stale are looked at as well.
          for (NumberedCurve &curve : curves)
            curve.stale = false;
          const bool said =
            Heddle::Contact::are_apart(curves, distance, window);
          for (NumberedCurve &curve : curves)
            curve.stale = true;
          n_wrong += said == none ? 0 : 1;
          n_apart += said ? 1 : 0;
          n_more += said && !pairs.empty() ? 1 : 0;
        }
    }
  deallog << "apart as often as not: "
          << (n_apart > 50 && n_apart < 250 ? "yes" : "no") << ", wrong "
          << n_wrong << ", near to themselves only, within the window: "
          << (n_more > 20 ? "often" : "seldom") << std::endl;
}



int
main()
{
  initlog();
  run_part("Candidates", candidates);
  run_part("Distances of all fibers", apart);
  run_part("Cells that are passed over", passed_over);
  run_part("Fibers that are searched anew", searched_in_part);
}
