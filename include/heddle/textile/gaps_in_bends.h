#ifndef heddle_textile_gaps_in_bends_h
#define heddle_textile_gaps_in_bends_h

#include <heddle/textile/fiber_path.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace Textile
  {
    /**
     * A sentence about fibers of the file @p name two of whose points are so
     * far apart that the mean line of their yarn bends, between the planes
     * across these two, by more than a radius off the straight line; empty if
     * there are none. What is taken for such a fiber there is a guess: it may
     * run through those that its yarn runs around.
     */
    std::string
    gaps_in_bends(const std::vector<FiberPath> &paths, const std::string &name);
  } // namespace Textile
} // namespace Heddle

#endif
