#ifndef heddle_solver_cholesky_blocks_h
#define heddle_solver_cholesky_blocks_h

#include <petscmat.h>

#include <vector>

namespace Heddle
{
  namespace Solver
  {
    /**
     * A sparse symmetric matrix of 3x3 blocks of this rank alone, and its
     * Cholesky factorization by PETSc in the order that it has.
     * @note PETSc's time to find the structure of the factors grows like the
     * square of the rows: a matrix whose parts are not coupled is better made
     * of several of these.
     */
    class CholeskyBlocks
    {
    public:
      /** Numbers of a block. */
      static constexpr unsigned int size = 9;

      /**
       * Row r has blocks in the columns columns[r], ascending, the diagonal
       * first and none below it.
       */
      CholeskyBlocks(const std::vector<std::vector<PetscInt>> &columns);

      ~CholeskyBlocks();

      CholeskyBlocks(const CholeskyBlocks &) = delete;
      CholeskyBlocks &
      operator=(const CholeskyBlocks &) = delete;

      /** All blocks, row by row, the numbers of each column by column. */
      double *
      values();

      std::size_t
      n_blocks() const
      {
        return n_stored;
      }

      void
      factorize();

      /**
       * Whether pivot @p row of the last factorization is positive definite:
       * all of them are if the matrix is.
       */
      bool
      is_positive_definite(const unsigned int row) const;

      /** Solve for the right-hand side @p residual, of 3 numbers per row. */
      PetscErrorCode
      solve(const double *residual, double *result) const;

    private:
      std::size_t n_stored = 0;
      Mat         matrix   = nullptr;
      Mat         factor   = nullptr;
      Vec         right    = nullptr;
      Vec         left     = nullptr;
    };
  } // namespace Solver
} // namespace Heddle

#endif
