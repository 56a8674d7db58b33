#ifndef heddle_solver_force_search_h
#define heddle_solver_force_search_h

#include <heddle/solver/line_search.h>
#include <heddle/solver/linear_solver.h>

namespace Heddle
{
  namespace Solver
  {
    /**
     * The part of @p increment, of 1, 1/2, 1/4 and so on and no more than
     * @p longest, after which forces are less out of balance, or 0 if there is
     * none. @p increment solves the @p system, as last assembled, by @p solver.
     *
     * It is for tangents that are far from symmetric, where much slides with
     * friction. There is no energy then, and the work of unbalanced forces
     * along the step, by which LineSearch goes, may be next to nothing although
     * the step is a good one. What falls along the solution $d = -K^{-1} r$, as
     * $(1 - s)^2$ to begin with, is $r \cdot K_s^{-1} r$ with the symmetric
     * part $K_s$ of the tangent, or its preconditioner: a general level
     * function (P. Deuflhard 2011, Newton Methods for Nonlinear Problems,
     * section 3.3.1).
     *
     * The state and the residual of the system are as before where there is
     * none; else the residual is that after the last trial.
     * @note Collective.
     */
    double
    step_to_balance(System::State           &state,
                    const Contributions     &contributions,
                    System::BlockSystem     &system,
                    const LinearSolver      &solver,
                    const System::Increment &increment,
                    const double             longest);
  } // namespace Solver
} // namespace Heddle

#endif
