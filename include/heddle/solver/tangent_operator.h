#ifndef heddle_solver_tangent_operator_h
#define heddle_solver_tangent_operator_h

#include <heddle/system/block_system.h>

#include <petscmat.h>

namespace Heddle
{
  namespace Solver
  {
    /**
     * A part of the tangent of a BlockSystem, its matrix and the terms beside
     * it, for those that only multiply with it.
     */
    class TangentOperator
    {
    public:
      TangentOperator(const System::BlockSystem      &system,
                      const System::BlockSystem::Part part);

      ~TangentOperator();

      TangentOperator(const TangentOperator &) = delete;
      TangentOperator &
      operator=(const TangentOperator &) = delete;

      Mat
      matrix() const
      {
        return shell;
      }

    private:
      static PetscErrorCode
      multiply(Mat shell, Vec vector, Vec product);

      const System::BlockSystem      &system;
      const System::BlockSystem::Part part;
      Mat                             shell = nullptr;
    };
  } // namespace Solver
} // namespace Heddle

#endif
