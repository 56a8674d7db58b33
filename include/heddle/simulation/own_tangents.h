#ifndef heddle_simulation_own_tangents_h
#define heddle_simulation_own_tangents_h

#include <heddle/base/log.h>
#include <heddle/simulation/scene.h>

namespace Heddle
{
  namespace Simulation
  {
    /**
     * Tell how far the tangents of contributions that are not heddle's are from
     * the derivatives of their residuals, where fibers start and at load factor
     * 1.
     * @note Collective.
     */
    void
    print_own_tangents(Log &log, const Scene &scene);
  } // namespace Simulation
} // namespace Heddle

#endif
