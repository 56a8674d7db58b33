#ifndef heddle_solver_fiber_spin_h
#define heddle_solver_fiber_spin_h

#include <heddle/system/contribution.h>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    /**
     * Let no fiber spin about its own axis by more than 0.03, or by as much as
     * it moves, in radii, along an @p increment: what its sections turn by
     * about it is made smaller by one factor for each fiber. Return whether
     * there was any.
     *
     * Wires of a strand that is pulled do spin, as they come to lie on each
     * other, by less than they move.
     *
     * Where nothing rubs, and ends are free to turn, next to nothing resists
     * that fibers spin, and no force asks for it: what solvers leave of the
     * residual makes them spin by several radians at times. Sections are
     * vectors that increments are added to, so a turn by s stretches them by
     * s^2 / 2, which resists far more than what is spun for.
     * @note Collective. Fibers without sections do not spin.
     */
    bool
    limit_spin(const System::State &state, System::Increment &increment);
  } // namespace Solver
} // namespace Heddle

#endif
