#ifndef heddle_solver_tangent_error_h
#define heddle_solver_tangent_error_h

#include <heddle/solver/terms.h>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    /**
     * How far the tangent of @p term, which has begun a stage and a step, is
     * from the derivative of its residual: at a random distance of a hundredth
     * of a radius from @p state, along a random motion of all fibers, whose
     * derivative is taken by central differences over @p motion radii on
     * either side. The largest difference of the forces on a block over the
     * largest of them [-]: of a right tangent no more than round-off and the
     * square of @p motion, 0 where no forces change. The state is moved.
     * @note Collective.
     */
    double
    tangent_error(const std::shared_ptr<System::Contribution> &term,
                  System::State                               &state,
                  const double                                 motion);
  } // namespace Solver
} // namespace Heddle

#endif
