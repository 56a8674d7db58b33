#ifndef heddle_simulation_scene_notes_h
#define heddle_simulation_scene_notes_h

#include <heddle/simulation/scene.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace Simulation
  {
    /**
     * What is to be said of fibers as they are described: of yarns of a weave,
     * of points in a file that may not be in order, of elements that are too
     * short or too long.
     */
    std::vector<std::string>
    notes_on_fibers(const Scene &scene, const Parameters &parameters);

    /**
     * What is to be said of fibers that were given lying in each other, by
     * more than half a radius or where supports hold them. Throw InputError
     * where supports do for good. Those of a weave are not looked at.
     * @note Collective.
     */
    std::vector<std::string>
    overlaps_at_start(const Scene &scene, const Parameters &parameters);

    /**
     * "penetration 0.6 of the radius ...", the deepest one of the fibers that
     * were given if it is above @p allowed radii, or nothing.
     * @note Collective.
     */
    std::string
    deepest_overlap(const Scene      &scene,
                    const Parameters &parameters,
                    const double      allowed);

    /**
     * Why nothing may keep the plane of a bend, or nothing if something does.
     * @note Collective.
     */
    std::string
    missing_torsion(const Scene &scene, const Parameters &parameters);
  } // namespace Simulation
} // namespace Heddle

#endif
