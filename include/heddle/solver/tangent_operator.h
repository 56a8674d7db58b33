#ifndef heddle_solver_tangent_operator_h
#define heddle_solver_tangent_operator_h

#include <heddle/solver/fiber_blocks.h>
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

      /**
       * From now on multiply with @p new_bands, which are all of the matrix, or
       * with the matrix.
       */
      void
      set_bands(const FiberBlocks *new_bands)
      {
        bands = new_bands;
      }

    private:
      static PetscErrorCode
      multiply(Mat shell, Vec vector, Vec product);

      const System::BlockSystem      &system;
      const System::BlockSystem::Part part;
      const FiberBlocks              *bands = nullptr;
      Mat                             shell = nullptr;
    };
  } // namespace Solver
} // namespace Heddle

#endif
