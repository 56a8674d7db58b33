#ifndef heddle_simulation_notes_on_units_h
#define heddle_simulation_notes_on_units_h

#include <heddle/simulation/parameters.h>
#include <heddle/simulation/scene.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace Simulation
  {
    /**
     * Sentences about stiffnesses and radii of a fabric that no fibers and no
     * matrix have, as numbers in other units are. A scene computes in any
     * consistent units, so that these are no errors.
     */
    std::vector<std::string>
    notes_on_units(const Scene &scene, const Parameters &parameters);
  } // namespace Simulation
} // namespace Heddle

#endif
