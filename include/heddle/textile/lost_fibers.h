#ifndef heddle_textile_lost_fibers_h
#define heddle_textile_lost_fibers_h

#include <heddle/textile/fiber_path.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace Textile
  {
    /**
     * A sentence about fibers of the file @p name that end far from the ends of
     * their yarn (Heddle::YarnReach), such as those that were lost while
     * they were traced; empty if none does.
     */
    std::string
    lost_fibers(const std::vector<FiberPath> &paths, const std::string &name);
  } // namespace Textile
} // namespace Heddle

#endif
