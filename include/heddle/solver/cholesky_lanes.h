#ifndef heddle_solver_cholesky_lanes_h
#define heddle_solver_cholesky_lanes_h

#include <heddle/base/lanes.h>

#include <array>
#include <memory>
#include <vector>

namespace Heddle
{
  namespace Solver
  {
    /** Where a symmetric matrix of 3x3 blocks, and its factors, have blocks. */
    class FactorStructure
    {
    public:
      /**
       * Row r of the matrix has blocks in columns[r], ascending, the diagonal
       * first and none below it. Factors have more.
       */
      FactorStructure(std::vector<std::vector<unsigned int>> columns);

      unsigned int
      n_rows() const
      {
        return row_begin.size() - 1;
      }

      /** Number of blocks of the factors. */
      unsigned int
      n_blocks() const
      {
        return columns.size();
      }

      /** Number of a block that is there, row by row. */
      unsigned int
      position(const unsigned int row, const unsigned int column) const;

    private:
      friend class CholeskyLanes;

      std::vector<unsigned int> row_begin, columns;

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
      static constexpr unsigned int n_lanes = 4;

      CholeskyLanes(const std::shared_ptr<const FactorStructure> &structure);

      const FactorStructure &
      structure() const
      {
        return *shared_structure;
      }

      /** Begin anew, with matrices of zeros. */
      void
      clear();

      /** Set block number @p position, its columns one after the other. */
      void
      set_block(const unsigned int lane,
                const unsigned int position,
                const double      *block);

      /** Add to component d, d of a block. */
      void
      add(const unsigned int lane,
          const unsigned int position,
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
       * Solve for the right-hand sides @p residuals, one of each lane of which
       * the first 3 @p n_rows components are not zero, and write as many to
       * @p results. Lanes without a result are left out.
       */
      void
      solve(const std::array<const double *, n_lanes> &residuals,
            const std::array<unsigned int, n_lanes>   &n_rows,
            const std::array<double *, n_lanes>       &results) const;

    private:
      using Numbers = Lanes<n_lanes>;

      /** A block of each lane, its columns one after the other. */
      struct Block
      {
        Numbers values[9];
      };

      /** Three numbers of each lane. */
      struct Triple
      {
        Numbers values[3];
      };

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
