// Cells that were too far from contact at the search are passed over while
// fibers move: the elements are the same as without that, near ends, along
// parallel fibers and at crossings, of a fiber with itself too.
#include "../tests.h"
#include "random_fibers.h"

using Heddle::Contact::ContactCells;
using Heddle::Contact::ContactElement;

constexpr unsigned int n_fibers        = 30;
constexpr double       search_distance = 2., threshold = 0.05, skin = 0.05;

/** How many contact elements differ with what is passed over, of how many. */
struct Count
{
  unsigned int elements = 0, wrong = 0, near_cells = 0, cells = 0;
};



void
compare(const unsigned int seed, const double motion, Count &count)
{
  RandomNumbers             random(seed);
  std::vector<Tensor<1, 3>> directions;
  for (unsigned int k = 0; k < 3; ++k)
    directions.push_back(random.direction());
  std::vector<Knots> knots =
    random_fibers(n_fibers, directions, /*height=*/2., random);
  ContactCells cells(search_distance,
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



int
main()
{
  initlog();
  for (const double motion : {0., 0.25, 1.})
    {
      Count count;
      for (unsigned int seed = 0; seed < 40; ++seed)
        compare(seed, motion, count);
      deallog << "motion " << motion << ": more than 1000 elements: "
              << (count.elements > 1000 ? "yes" : "NO") << ", wrong "
              << count.wrong << ", cells passed over: "
              << (count.near_cells < 0.7 * count.cells ? "many" : "FEW")
              << std::endl;
    }
}
