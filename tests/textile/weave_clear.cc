// In the crimped start no warp fiber touches a weft fiber, unless that takes
// more than half as much crimp again as flat ribbons need: then it is in order
// only (see post/crossing_order). Within a yarn fibers keep their distance.
#include <heddle/textile/weave.h>

#include "../tests.h"

using namespace Heddle::Textile;



/** Smallest distance between the points of two lists of fibers, to a pitch. */
double
smallest_distance(const std::vector<FiberPath> &fibers, const bool same_yarn)
{
  double smallest = 1e300;
  for (const FiberPath &a : fibers)
    for (const FiberPath &b : fibers)
      if (same_yarn ? (&a < &b && a.yarn_id == 0 && b.yarn_id == 0)
                    : (a.set == "warp" && b.set == "weft"))
        for (const auto &p : a.points)
          for (const auto &q : b.points)
            smallest = std::min(smallest, (p - q).norm_square());
  return std::sqrt(smallest);
}



void
check(const std::string &pattern,
      const Layout       layout,
      const unsigned int n_bundles)
{
  WeaveDescription description;
  description.pattern                = pattern;
  description.warp.n_yarns           = 2;
  description.warp.packing.layout    = layout;
  description.warp.packing.n_bundles = n_bundles;
  description.warp.packing.radius    = 0.0045;
  description.weft                   = description.warp;

  const Weave  weave(description);
  const auto   fibers = weave.paths(150);
  const double scale  = 1. / description.warp.packing.radius;
  deallog << pattern << (layout == Layout::rows ? ", rows, " : ", hexagonal, ")
          << n_bundles << " x 12: amplitude " << scale * weave.amplitude()
          << " R at a pitch of " << scale * weave.warp_spacing()
          << " R, warp touches weft "
          << (scale * smallest_distance(fibers, false) < 2.)
          << ", fibers of a yarn "
          << std::floor(10. * scale * smallest_distance(fibers, true)) / 10.
          << " R apart or more" << std::endl;
}



int
main()
{
  initlog();
  for (const std::string pattern : {"plain", "twill 2/2"})
    for (const Layout layout : {Layout::rows, Layout::hexagonal})
      for (const unsigned int n_bundles : {1, 3})
        check(pattern, layout, n_bundles);
}
