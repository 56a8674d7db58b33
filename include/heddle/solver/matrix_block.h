#ifndef heddle_solver_matrix_block_h
#define heddle_solver_matrix_block_h

#include <heddle/system/local_blocks.h>
#include <heddle/system/state.h>

#include <petscpc.h>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    /**
     * Approximate inverse of what the tangent holds between the nodes of the
     * matrix of this rank: a symmetric sweep of Gauss and Seidel over its
     * nodes. It is positive definite whenever that part of the tangent is,
     * which an incomplete factorization need not be.
     */
    class MatrixBlock
    {
    public:
      MatrixBlock(const System::State &state);

      ~MatrixBlock();

      MatrixBlock(const MatrixBlock &) = delete;
      MatrixBlock &
      operator=(const MatrixBlock &) = delete;

      /** Take this part of a tangent. */
      void
      set_up(const System::LocalBlocks &tangent);

      /**
       * Write to @p result what @p residual gives, for the own nodes of the
       * matrix. PETSc calls this: errors are returned, not thrown.
       */
      PetscErrorCode
      apply(const double *residual, double *result) const;

    private:
      void
      clear();

      const System::State &state;
      Mat                  block  = nullptr;
      PC                   pc     = nullptr;
      Vec                  input  = nullptr;
      Vec                  output = nullptr;
    };
  } // namespace Solver
} // namespace Heddle

#endif
