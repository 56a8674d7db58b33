#ifndef heddle_textile_check_paths_h
#define heddle_textile_check_paths_h

#include <heddle/textile/fiber_path.h>

#include <vector>

namespace Heddle
{
  namespace Textile
  {
    using namespace dealii;

    /**
     * Throw an InputError if two fibers have the same axis, or parts of it: no
     * normal tells where contact is to push them.
     */
    void
    check_paths(const std::vector<FiberPath> &paths);
  } // namespace Textile
} // namespace Heddle

#endif
