// What the rectangle of a matrix reaches over: all of what lies across, with
// its surface, and of what runs along the part in common. Where all runs one
// way, as in a unidirectional composite, the outer fibers are not cut, and
// fibers without a yarn count as yarns do.
#include <heddle/textile/fabric_reach.h>

#include "../tests.h"

using namespace Heddle::Textile;

constexpr double radius = 0.2;



/** @p n fibers along axis @p d from 0 to 4, one mm from each other. */
std::vector<FiberAxis>
row(const unsigned int d, const unsigned int n, const unsigned int yarn_id)
{
  std::vector<FiberAxis> fibers;
  for (unsigned int i = 0; i < n; ++i)
    {
      Tensor<1, 3> begin;
      begin[(d + 1) % 3] = i;
      Tensor<1, 3> end   = begin;
      end[d]             = 4.;
      fibers.push_back({{begin, end}, radius, yarn_id});
    }
  return fibers;
}



void
show(const std::string &what, const std::vector<FiberAxis> &fibers)
{
  deallog << what << ": rectangle";
  for (const unsigned int d : {0, 1})
    {
      const Extent reach = reach_along(fibers, d);
      deallog << ' ' << reach.low << " to " << reach.high;
    }
  const Extent height = extent_of(fibers, 2);
  deallog << ", height " << height.low << " to " << height.high << std::endl;
}



/**
 * Three fibers along x, of one yarn: some given from their other ends, one lost
 * half way, or all of staple fibers, with gaps, none of which runs from end to
 * end.
 */
void
show_yarns()
{
  std::vector<FiberAxis> turned = row(0, 3, 0);
  std::swap(turned[1].points[0], turned[1].points[1]);
  show("one turned", turned);

  std::vector<FiberAxis> lost = row(0, 3, 0);
  lost[2].points[1][0]        = 1.;
  show("one lost", lost);

  std::vector<FiberAxis> spun;
  for (FiberAxis fiber : row(0, 3, 0))
    {
      const double cut   = 1. + spun.size() / 2;
      fiber.points[1][0] = cut - 0.2;
      spun.push_back(fiber);
      fiber.points[0][0] = 4.;
      fiber.points[1][0] = cut;
      spun.push_back(fiber);
    }
  show("spun", spun);
}



int
main()
{
  initlog();
  show("Three along x, no yarn", row(0, 3, no_id));
  show("one yarn along x", row(0, 3, 0));
  show("one yarn along z", row(2, 3, 0));

  // A yarn along x from y = 0 to 2, and one along y that begins at y = -1.
  std::vector<FiberAxis> fibers = row(0, 3, 0);
  fibers.push_back(
    {{Tensor<1, 3>({3., -1., 0.5}), Tensor<1, 3>({3., 6., 0.5})}, radius, 1});
  show("with one across", fibers);
  fibers.push_back(
    {{Tensor<1, 3>({0., 7., 0.}), Tensor<1, 3>({4., 7., 0.})}, radius, no_id});
  show("with one of no yarn beside", fibers);
  show_yarns();
}
