#ifndef heddle_simulation_crossing_report_h
#define heddle_simulation_crossing_report_h

#include <heddle/simulation/fabric_report.h>
#include <heddle/simulation/scene.h>

#include <string>

namespace Heddle
{
  namespace Simulation
  {
    /**
     * The crossings of yarns a and b of two sets, as CSV, one line each: where
     * they are, which yarn is on top, how many of their fibers lie otherwise,
     * and what presses between them. Of a weave these are the crossings of its
     * pattern, warp with weft; else those that the mean lines of the yarns have
     * in the plane of the fabric. A head alone where there are none, and
     * nothing without yarns.
     *
     * @note Collective; other ranks than the first return nothing.
     */
    std::string
    crossings_csv(const Scene &scene, const FabricReport &fabric);
  } // namespace Simulation
} // namespace Heddle

#endif
