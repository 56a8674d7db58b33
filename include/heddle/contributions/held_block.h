#ifndef heddle_contributions_held_block_h
#define heddle_contributions_held_block_h

#include <heddle/contributions/support.h>
#include <heddle/system/state.h>

#include <array>
#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /** A block of unknowns that supports hold, wholly or in part. */
    struct HeldBlock
    {
      /** What the block is, and what of it is held. */
      enum class Kind
      {
        position,  /**< components of the position */
        section,   /**< all of a section vector, turned with the section */
        direction, /**< the direction of a tangent, turned with the section */
        tangent    /**< components of a tangent */
      };

      static constexpr unsigned int nobody = static_cast<unsigned int>(-1);

      /** A fiber and one of its blocks, or nobody and a node of the matrix. */
      unsigned int fiber;
      unsigned int block; /**< counted from the fiber's first */
      Kind         kind;
      /** Of its node, or the middle of the body with which it moves [mm]. */
      Tensor<1, 3> position;
      Tensor<1, 3> reference; /**< the block in the reference configuration */

      /** Number of the support that holds a component, or nobody. */
      std::array<unsigned int, 3> holder = {{nobody, nobody, nobody}};

      bool
      is_in_matrix() const
      {
        return fiber == nobody;
      }

      /** Local number of the block, or nobody if it is not held here. */
      unsigned int
      local_block(const System::State &state) const;
    };

    /**
     * Return all blocks that @p supports hold, on all ranks, by fiber and
     * block. Two supports may hold different components of a block, or the same
     * one in the same way; throw InputError for what does not go together.
     * @p reference are the owned blocks in the reference configuration;
     * @p matrix may be nullptr. On @p will_settle see
     * NodeSelection::find_nodes().
     * @note Collective.
     */
    std::vector<HeldBlock>
    find_held_blocks(const System::FiberSpace        &space,
                     const std::vector<Tensor<1, 3>> &reference,
                     const SupportList               &supports,
                     const System::MatrixSpace       *matrix,
                     const bool                       will_settle = false);
  } // namespace Contributions
} // namespace Heddle

#endif
