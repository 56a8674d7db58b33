#ifndef heddle_simulation_scene_description_h
#define heddle_simulation_scene_description_h

#include <heddle/base/log.h>
#include <heddle/simulation/scene.h>

namespace Heddle
{
  namespace Simulation
  {
    /**
     * Say what a scene is before it is computed: its sizes, what is to be said
     * of it, what it will take. Throw InputError if it cannot be computed.
     * @note Collective.
     */
    void
    print_description(Log              &log,
                      const Scene      &scene,
                      const Parameters &parameters);
  } // namespace Simulation
} // namespace Heddle

#endif
