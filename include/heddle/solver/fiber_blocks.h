#ifndef heddle_solver_fiber_blocks_h
#define heddle_solver_fiber_blocks_h

#include <heddle/solver/cholesky_lanes.h>
#include <heddle/system/local_blocks.h>
#include <heddle/system/state.h>

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
     * Fibers of about as many nodes are factorized, solved and multiplied with
     * side by side; that changes no digit of any.
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

      /** Have no blocks until others are taken. */
      void
      forget()
      {
        groups.clear();
      }

      /** Solve for the right-hand side @p residual of the own fibers. */
      void
      apply(const double *residual, double *result) const;

      /** Whether a fiber is unstable by itself. */
      bool
      has_unstable() const
      {
        return unstable;
      }

      /** Whether the tangent has nothing on this rank but these bands: ... */
      bool
      are_all() const
      {
        return no_others;
      }

      /** ... its product, of the own fibers, without any shift. */
      void
      multiply(const double *vector, double *product) const;

    private:
      static constexpr unsigned int n_lanes = MatrixLanes::n_lanes;

      /** Fibers that are computed together, in as many lanes. */
      struct Group
      {
        std::vector<unsigned int> fibers;
        MatrixLanes               bands;
        CholeskyLanes             factors;
      };

      /**
       * Call @p action(row, offset, values) for the blocks within the band of a
       * fiber, and @p others(values) for others of its rows.
       */
      template <typename Action, typename OtherAction>
      void
      for_each_block(const System::LocalBlocks &tangent,
                     const unsigned int         fiber,
                     const Action              &action,
                     const OtherAction         &others) const;

      /**
       * Note which blocks a tangent couples, and whether in bands only; return
       * whether there are more than before.
       */
      bool
      find_couplings(const System::LocalBlocks &tangent);

      /** Make the groups. */
      void
      create();

      /** Of the band of a fiber with so many rows. */
      std::shared_ptr<const BlockStructure>
      structure(const unsigned int n_rows) const;

      /** Take the bands of @p group; lanes and rows of no fiber are unit ones.
       */
      void
      take(const System::LocalBlocks &tangent, Group &group) const;

      /** Factorize @p group, with shifts if it must be. */
      void
      factorize(Group &group);

      /**
       * Add to the diagonal of the fiber of a lane @p grown times the first
       * shifts.
       */
      void
      shift(const unsigned int lane, const double grown, Group &group) const;

      /** Where the fibers of a group have their part of @p vector, ... */
      MatrixLanes::Vectors
      parts(const Group &group, const double *vector) const;

      /** ... and that of @p vector that is to be written. */
      std::array<double *, n_lanes>
      results(const Group &group, double *vector) const;

      /** Blocks of a node are of different kinds: position, section vectors. */
      unsigned int
      kind(const unsigned int row) const
      {
        return row % state.space.n_blocks_per_node();
      }

      unsigned int
      n_rows(const unsigned int fiber) const
      {
        return state.held_blocks(fiber).second - state.held_blocks(fiber).first;
      }

      const System::State &state;
      double               section_shift; /**< the first one */
      const unsigned int n_offsets; /**< blocks from the diagonal to the end */

      /** Whether rows of a kind couple to the block so many further. */
      std::vector<std::vector<bool>> coupled;

      bool               no_others = false;
      bool               unstable  = false;
      std::vector<Group> groups;
    };
  } // namespace Solver
} // namespace Heddle

#endif
