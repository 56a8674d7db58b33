#ifndef heddle_simulation_stray_fibers_h
#define heddle_simulation_stray_fibers_h

#include <heddle/textile/fiber_path.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace Simulation
  {
    /**
     * A sentence about fibers of a fabric, from the file @p name, that pass
     * fibers of the other set on the other side than most fibers of the same
     * two yarns do, seen along z; empty if none does. A fiber of which points
     * are missing runs straight through the yarns that it should pass, and
     * contact keeps it among their fibers. Fibers without a yarn, or of other
     * sets than warp and weft, are not looked at.
     */
    std::string
    stray_fibers(const std::vector<Textile::FiberPath> &paths,
                 const std::string                     &name);
  } // namespace Simulation
} // namespace Heddle

#endif
