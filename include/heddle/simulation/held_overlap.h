#ifndef heddle_simulation_held_overlap_h
#define heddle_simulation_held_overlap_h

#include <heddle/contributions/fiber_contact.h>
#include <heddle/contributions/supports.h>

#include <string>

namespace Heddle
{
  namespace Simulation
  {
    using namespace dealii;

    /**
     * Find nodes of two fibers whose positions supports prescribe although they
     * lie in each other by more than @p threshold radii at the start, side by
     * side. No contact force moves them apart.
     *
     * Where both are ends of their fibers, and supports hold them so at load
     * factor 1, too, there is no equilibrium: contact looks at ends in any
     * case. Then throw InputError. Elsewhere return a sentence for a note, or
     * nothing: supports may take them apart, and amid a fiber contact may meet
     * the places beside the nodes only.
     *
     * @p contact is as it was updated where the fibers start.
     * @note Collective; the same on all ranks.
     */
    std::string
    held_overlap(const System::FiberSpace          &space,
                 const Contributions::FiberContact &contact,
                 const Contributions::Supports     &supports,
                 const double                       threshold);
  } // namespace Simulation
} // namespace Heddle

#endif
