// Only fibers that moved far are searched anew, again and again: the elements
// are those of a search of all.
#include "../tests.h"
#include "random_fibers.h"

using Heddle::Contact::ContactCells;
using Heddle::Contact::ContactElement;

constexpr unsigned int n_fibers = 30, n_rounds = 8;
constexpr double       search_distance = 3.5, threshold = 0.05, skin = 0.05;

/** As far as a fiber may have moved without being searched anew. */
constexpr double stale = 0.6;

/** Elements that differ, of how many, and fibers that were searched anew. */
struct Count
{
  unsigned int elements = 0, wrong = 0, searched = 0, fibers = 0;
};



void
compare(const unsigned int seed, const double motion, Count &count)
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
  const ContactCells        none(search_distance,
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



int
main()
{
  initlog();
  for (const double motion : {0.1, 0.3, 0.8})
    {
      Count count;
      for (unsigned int seed = 0; seed < 15; ++seed)
        compare(seed, motion, count);
      deallog << "motion " << motion << ": more than 1000 elements: "
              << (count.elements > 1000 ? "yes" : "NO") << ", wrong "
              << count.wrong << ", some searched anew, not all: "
              << (count.searched > 0 && count.searched < count.fibers ? "yes"
                                                                      : "NO")
              << std::endl;
    }
}
