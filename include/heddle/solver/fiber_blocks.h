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
     * Fibers of about as many nodes are factorized and solved side by side;
     * that changes no digit of any.
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
      void
      apply(const double *residual, double *result) const;

    private:
      static constexpr unsigned int n_lanes = CholeskyLanes::n_lanes;

      /** Fibers that are factorized together, in as many lanes. */
      struct Group
      {
        std::vector<unsigned int> fibers;
        CholeskyLanes             factors;
      };

      /** Call @p action(row, offset, values) for the blocks within a band. */
      template <typename Action>
      void
      for_each_block(const System::LocalBlocks &tangent,
                     const unsigned int         fiber,
                     const Action              &action) const;

      /** Note which blocks a tangent couples; return whether there are more. */
      bool
      find_couplings(const System::LocalBlocks &tangent);

      /** Make the groups. */
      void
      create();

      /** Of a fiber with so many rows. */
      std::shared_ptr<const FactorStructure>
      structure(const unsigned int n_rows) const;

      /** Factorize @p group, with shifts if it must be. */
      void
      factorize(const System::LocalBlocks &tangent, Group &group) const;

      /**
       * Take the matrix of @p fiber, with @p grown times the first shifts on
       * its diagonal.
       */
      void
      take(const System::LocalBlocks &tangent,
           const unsigned int         fiber,
           const double               grown,
           const unsigned int         lane,
           Group                     &group) const;

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

      std::vector<Group> groups;
    };
  } // namespace Solver
} // namespace Heddle

#endif
