#ifndef heddle_contributions_near_fibers_h
#define heddle_contributions_near_fibers_h

#include <heddle/contributions/centerlines.h>
#include <heddle/system/state.h>

#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    /**
     * Return the pieces of foreign fibers that may come near the own ones, in
     * ascending order: all intervals whose boxes, grown by @p margin [mm], meet
     * the grown box of some own fiber, and the nodes that their centerline
     * follows from. Each rank decides about its own @p centerlines for the
     * others, of which it knows the boxes of whole fibers.
     *
     * The margin must be at least the radius of the fibers plus half of the
     * search distance, by which Contact::find_candidates() grows the boxes of
     * the same control points: otherwise a pair may be missed whose foreign
     * fiber is no ghost.
     * @note Collective.
     */
    std::vector<System::GhostFiber>
    find_near_fibers(const System::FiberSpace &space,
                     const Centerlines        &centerlines,
                     const double              margin);

    /** Whether @p state holds all of these pieces. */
    bool
    holds(const System::State                   &state,
          const std::vector<System::GhostFiber> &near);

    /** The same pieces, each longer by @p n_nodes to both sides. */
    std::vector<System::GhostFiber>
    lengthened(const System::FiberSpace       &space,
               std::vector<System::GhostFiber> near,
               const unsigned int              n_nodes);
  } // namespace Contributions
} // namespace Heddle

#endif
