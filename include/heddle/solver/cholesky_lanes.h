#ifndef heddle_solver_cholesky_lanes_h
#define heddle_solver_cholesky_lanes_h

#include <heddle/solver/matrix_lanes.h>

#include <array>
#include <memory>
#include <vector>

namespace Heddle
{
  namespace Solver
  {
    /** Where the factors of symmetric matrices of 3x3 blocks have blocks. */
    class FactorStructure
    {
    public:
      FactorStructure(const BlockStructure &matrix);

    private:
      friend class CholeskyLanes;

      /** Rows of the matrix, and what couples as rows are eliminated. */
      BlockStructure factors;

      /** Numbers of the blocks of the matrix among those of the factors. */
      std::vector<unsigned int> of_matrix;

      /**
       * Which blocks change as rows are eliminated, one after the other: those
       * between each two of the columns of the row.
       */
      std::vector<unsigned int> changed;
    };



    /**
     * Factorizations @f$ A = U^T D U @f$ of a few matrices of one structure at
     * once, side by side in registers, in the order that they have. Solving
     * for one of them alone goes from row to row and waits for each; of several
     * it waits for memory.
     */
    class CholeskyLanes
    {
    public:
      static constexpr unsigned int n_lanes = MatrixLanes::n_lanes;

      CholeskyLanes(const std::shared_ptr<const FactorStructure> &structure);

      /** Begin with the matrices @p matrices. */
      void
      take(const MatrixLanes &matrices);

      /** Add to component d, d of the diagonal block of a row. */
      void
      add(const unsigned int lane,
          const unsigned int row,
          const unsigned int d,
          const double       value);

      /** Replace the matrices by their factors. */
      void
      factorize();

      /** Whether the matrix was, as factorized last. */
      bool
      is_positive_definite(const unsigned int lane) const
      {
        return positive[lane];
      }

      /**
       * Solve for the right-hand sides @p residuals and write as many rows to
       * @p results. Lanes without a result are left out.
       */
      void
      solve(const MatrixLanes::Vectors          &residuals,
            const std::array<double *, n_lanes> &results) const;

    private:
      using Numbers = MatrixLanes::Numbers;
      using Block   = MatrixLanes::Block;
      using Triple  = MatrixLanes::Triple;

      /** Invert a diagonal block, and note where it is not definite. */
      void
      invert(Block &block);

      std::shared_ptr<const FactorStructure> shared_structure;

      /** Of rows of U but for their diagonal, where the inverse of D is. */
      std::vector<Block>          blocks;
      std::vector<Block>          eliminated; /**< the row as it was before */
      mutable std::vector<Triple> solution;
      std::array<bool, n_lanes>   positive;
    };
  } // namespace Solver
} // namespace Heddle

#endif
