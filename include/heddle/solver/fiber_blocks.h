#ifndef heddle_solver_fiber_blocks_h
#define heddle_solver_fiber_blocks_h

#include <heddle/solver/cholesky_blocks.h>
#include <heddle/system/local_blocks.h>
#include <heddle/system/state.h>

#include <memory>
#include <vector>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    /**
     * A Cholesky factorization of each fiber of this rank, within its band. The
     * band holds the elasticity of the fiber and what contact and links to a
     * matrix add to it; coupling to other fibers and to the matrix is left out.
     *
     * A few fibers at a time are one sparse matrix of blocks of three, without
     * coupling between them: their factors fit into the cache, so that a
     * solution reads them from memory once and not twice.
     */
    class FiberBlocks
    {
    public:
      FiberBlocks(const System::State &state);

      /**
       * Take the blocks from a tangent and factorize them. A @p gentle shift
       * makes unstable fibers just stable.
       */
      void
      set_up(const System::LocalBlocks &tangent, const bool gentle = false);

      /** Solve for the right-hand side @p residual of the own fibers. */
      PetscErrorCode
      apply(const double *residual, double *result) const;

    private:
      /** Fibers that are factorized together. */
      struct Group
      {
        unsigned int                    first_fiber, end_fiber, first_row;
        std::unique_ptr<CholeskyBlocks> blocks;
      };

      /** Call @p action(row, offset, values) for the blocks within bands. */
      template <typename Action>
      void
      for_each_block(const System::LocalBlocks &tangent,
                     const unsigned int         first_fiber,
                     const unsigned int         end_fiber,
                     const Action              &action) const;

      /** Note which blocks a tangent couples; return whether there are more. */
      bool
      find_couplings(const System::LocalBlocks &tangent);

      /** Make the groups and their matrices. */
      void
      create();

      void
      add_group(const unsigned int first_fiber, const unsigned int end_fiber);

      /** Factorize @p group, with shifts if it must be. */
      void
      factorize(Group &group);

      /** Position in its group of the block of @p row and row + @p offset. */
      std::size_t
      position(const Group       &group,
               const unsigned int row,
               const unsigned int offset) const
      {
        return row_begin[row] - row_begin[group.first_row] +
               rank_of_offset[kind(row)][offset];
      }

      /** Blocks of a node are of different kinds: position, section vectors. */
      unsigned int
      kind(const unsigned int row) const
      {
        return row % state.space.n_blocks_per_node();
      }

      /**
       * Change what is added to the diagonal of a fiber from @p before to
       * @p after times the first shifts.
       */
      void
      shift(Group             &group,
            const unsigned int fiber,
            const double       before,
            const double       after);

      /** The fibers that are not positive definite as factorized last. */
      std::vector<unsigned int>
      find_unstable(const Group &group) const;

      const System::State &state;
      double               section_shift; /**< the first one */
      const unsigned int n_offsets; /**< blocks from the diagonal to the end */

      /** Whether rows of a kind couple to the block so many further. */
      std::vector<std::vector<bool>> coupled;

      /** The how manieth of those that it couples to. */
      std::vector<std::vector<unsigned int>> rank_of_offset;

      std::vector<std::size_t> row_begin;
      std::vector<Group>       groups;
    };
  } // namespace Solver
} // namespace Heddle

#endif
