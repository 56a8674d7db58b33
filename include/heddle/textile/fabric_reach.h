#ifndef heddle_textile_fabric_reach_h
#define heddle_textile_fabric_reach_h

#include <heddle/textile/extent.h>
#include <heddle/textile/fiber_axis.h>

#include <vector>

namespace Heddle
{
  namespace Textile
  {
    /**
     * What holds fibers along axis @p d, surfaces included: one reaches beyond
     * its axis by its radius, but not beyond its ends if it runs along d [mm].
     */
    Extent
    extent_of(const std::vector<FiberAxis> &fibers, const unsigned int d);

    /**
     * What the side of a rectangle around fibers reaches over along axis @p d,
     * x or y: all that lies across d, surfaces included, and of what runs along
     * d the part that all have in common, which ends where the ends of a yarn
     * are in the mean. A fiber that belongs to no yarn is one of its own [mm].
     */
    Extent
    reach_along(const std::vector<FiberAxis> &fibers, const unsigned int d);
  } // namespace Textile
} // namespace Heddle

#endif
