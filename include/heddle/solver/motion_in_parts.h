#ifndef heddle_solver_motion_in_parts_h
#define heddle_solver_motion_in_parts_h

#include <heddle/base/signals.h>
#include <heddle/solver/equations.h>

namespace Heddle
{
  namespace Solver
  {
    /**
     * Move the state along a @p guess of the motion of the owned blocks to an
     * equilibrium, in parts that all terms allow, as far as it is credible;
     * return whether it was followed at all.
     * @note Collective. Throws Stopped if asked to @p stop.
     */
    bool
    follow(Equations               &equations,
           const System::Increment &guess,
           StopRequest             &stop);

    /**
     * The part of @p increment, no more than 1, that may be taken where no
     * fibers are near each other: they are moved along it as far as is known,
     * and searched again, until some are near. A new system would ask for the
     * same way. Ghosts of @p increment follow those of the state, which stays.
     * @note Collective.
     */
    double
    walk(Equations &equations, System::Increment &increment);
  } // namespace Solver
} // namespace Heddle

#endif
