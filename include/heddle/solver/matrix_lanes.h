#ifndef heddle_solver_matrix_lanes_h
#define heddle_solver_matrix_lanes_h

#include <heddle/base/lanes.h>

#include <array>
#include <memory>
#include <vector>

namespace Heddle
{
  namespace Solver
  {
    /** Where a symmetric matrix of 3x3 blocks has blocks. */
    class BlockStructure
    {
    public:
      /**
       * Row r has blocks in columns[r], ascending, the diagonal first and none
       * below it.
       */
      BlockStructure(const std::vector<std::vector<unsigned int>> &columns);

      unsigned int
      n_rows() const
      {
        return row_begin.size() - 1;
      }

      unsigned int
      n_blocks() const
      {
        return columns.size();
      }

      /** Number of a block that is there, row by row. */
      unsigned int
      position(const unsigned int row, const unsigned int column) const;

      /** Number of the first block of a row, the diagonal, and one past the
       * last row. */
      std::vector<unsigned int> row_begin;

      std::vector<unsigned int> columns; /**< of blocks */
    };



    /** A few of such matrices, of one structure, side by side in registers. */
    class MatrixLanes
    {
    public:
      static constexpr unsigned int n_lanes = 4;
      using Numbers                         = Lanes<n_lanes>;

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

      /** A vector of each lane: where its components are, three of a row. */
      struct Vectors
      {
        std::array<const double *, n_lanes> begin;
        std::array<unsigned int, n_lanes>   n_rows; /**< others are zero */
      };

      /** Matrices of zeros. */
      MatrixLanes(const std::shared_ptr<const BlockStructure> &structure);

      const BlockStructure &
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

      /** Component d, d of the diagonal block of a row. */
      double
      diagonal(const unsigned int lane,
               const unsigned int row,
               const unsigned int d) const
      {
        return blocks[shared_structure->row_begin[row]].values[4 * d][lane];
      }

      const std::vector<Block> &
      all_blocks() const
      {
        return blocks;
      }

      /**
       * Multiply with @p vectors and write as many rows to @p products. Lanes
       * without a product are left out.
       */
      void
      multiply(const Vectors                       &vectors,
               const std::array<double *, n_lanes> &products) const;

      /** Put vectors side by side, ... */
      static void
      gather(const Vectors &vectors, std::vector<Triple> &rows);

      /** ... and apart again: @p n_rows of each lane to @p results, where there
       * is one. */
      static void
      scatter(const std::vector<Triple>               &rows,
              const std::array<unsigned int, n_lanes> &n_rows,
              const std::array<double *, n_lanes>     &results);

    private:
      std::shared_ptr<const BlockStructure> shared_structure;
      std::vector<Block>                    blocks;
      mutable std::vector<Triple>           input, output;
    };
  } // namespace Solver
} // namespace Heddle

#endif
