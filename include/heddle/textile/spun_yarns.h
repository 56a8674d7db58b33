#ifndef heddle_textile_spun_yarns_h
#define heddle_textile_spun_yarns_h

#include <heddle/textile/fiber_path.h>

#include <array>
#include <string>
#include <vector>

namespace Heddle
{
  namespace Textile
  {
    /**
     * Whether the first and the last point of each fiber are ends that are
     * pulled and held as ends of its yarn. All are, but for those of staple
     * fibers in the midst of a yarn of which none runs from end to end
     * (Heddle::YarnReach), which are free.
     */
    std::vector<std::array<bool, 2>>
    ends_of_yarns(const std::vector<FiberPath> &paths);

    /**
     * A sentence about yarns of the file @p name that are spun of staple
     * fibers; empty if there are none.
     */
    std::string
    spun_yarns(const std::vector<FiberPath> &paths, const std::string &name);
  } // namespace Textile
} // namespace Heddle

#endif
