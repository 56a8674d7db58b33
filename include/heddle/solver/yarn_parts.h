#ifndef heddle_solver_yarn_parts_h
#define heddle_solver_yarn_parts_h

#include <heddle/system/state.h>

#include <vector>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    /** Fibers, by their numbers. */
    using FiberNumbers = std::vector<unsigned int>;

    /**
     * Divide the yarns of more than one fiber into parts of neighbours, one for
     * each dozen of fibers that is begun, but no more than four: cut them
     * across the longest side of their section, as it is now at the middles of
     * the fibers, and the pieces again. Fibers of no yarn are taken for
     * those of one more. Every fiber of these yarns is in one part; parts of a
     * yarn differ by one fiber at most. They are the same on all ranks.
     * @note Collective.
     */
    std::vector<FiberNumbers>
    yarn_parts(const System::State &state);
  } // namespace Solver
} // namespace Heddle

#endif
