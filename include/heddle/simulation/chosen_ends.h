#ifndef heddle_simulation_chosen_ends_h
#define heddle_simulation_chosen_ends_h

#include <heddle/simulation/scene.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace Simulation
  {
    /**
     * What is to be said of the ends that supports and loads choose of fibers
     * from a file: where fibers of a set lie side by side, 'first end' is on
     * the other side of those whose points run the other way, and an end of a
     * fiber that was lost lies amid the others.
     */
    std::vector<std::string>
    notes_on_chosen_ends(const Scene &scene, const Parameters &parameters);

    /**
     * What is to be said of ends of fibers that face each other nearer than
     * their surfaces allow, as where a fiber was cut or closed to a loop; or
     * nothing.
     */
    std::string
    ends_that_meet(const Scene &scene);
  } // namespace Simulation
} // namespace Heddle

#endif
