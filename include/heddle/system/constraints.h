#ifndef heddle_system_constraints_h
#define heddle_system_constraints_h

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <vector>

namespace Heddle
{
  namespace System
  {
    using namespace dealii;

    /** Prescribed motion of some components of one block. */
    struct Constraint
    {
      unsigned int          block;   /**< local number */
      std::array<bool, 3>   fixed;   /**< by row of the frame */
      Tensor<2, 3>          frame;   /**< rows: orthonormal directions */
      std::array<double, 3> pending; /**< what remains to be moved [mm or -] */
    };

    /**
     * What is prescribed, and what that makes of blocks of a tangent and of
     * vectors of blocks.
     *
     * A block may be *constrained*: some of its components along the rows of an
     * orthonormal frame are *fixed*, they have to move by a prescribed amount.
     * The linear system has such blocks in their frames, and fixed components
     * are no unknowns of it.
     *
     * Vectors have the owned blocks, or all local ones; what is prescribed of
     * other blocks does not matter to them.
     */
    class Constraints
    {
    public:
      /** From now on these, of @p n_blocks local blocks. */
      void
      set(const std::vector<Constraint> &constraints,
          const unsigned int             n_blocks);

      /** There are @p n_blocks local blocks now: those that came are free. */
      void
      set_n_blocks(const unsigned int n_blocks)
      {
        constraint_of_block.resize(n_blocks, -1);
      }

      bool
      is_constrained(const unsigned int block) const
      {
        return constraint_of_block[block] >= 0;
      }

      /** Whether any of these @p n blocks is constrained. */
      bool
      is_any_constrained(const unsigned int n, const unsigned int *blocks) const
      {
        return std::any_of(
          blocks, blocks + n, [this](const unsigned int block) {
            return is_constrained(block);
          });
      }

      /** Whether the block's component along row @p d of its frame is fixed. */
      bool
      is_fixed(const unsigned int block, const unsigned int d) const
      {
        return is_constrained(block) && of(block).fixed[d];
      }

      /** What remains to be moved of a constrained block, in space. */
      Tensor<1, 3>
      motion(const unsigned int block) const;

      /** The components of @p value in the frame of a block, if it has one. */
      Tensor<1, 3>
      in_frame(const unsigned int block, const Tensor<1, 3> &value) const
      {
        return is_constrained(block) ? of(block).frame * value : value;
      }

      /**
       * A 3x3 block @p value of the tangent between two local blocks as the
       * matrix has it: in their frames, and without what is fixed.
       */
      Tensor<2, 3>
      constrained(const unsigned int  row,
                  const unsigned int  column,
                  const Tensor<2, 3> &value) const
      {
        return is_constrained(row) || is_constrained(column)
                 ? turned_and_cleared(row, column, value)
                 : value;
      }

      /**
       * The same in place for the @p tangent of @p n local blocks, 3n x 3n by
       * rows. Add the forces that the pending motion raises on owned blocks, in
       * their frames, to @p lifting, which has these blocks.
       */
      void
      eliminate(const unsigned int         n,
                const unsigned int        *blocks,
                double                    *tangent,
                std::vector<Tensor<1, 3>> &lifting) const;

      /** From space into the frames, ... */
      void
      turn_into_frames(std::vector<Tensor<1, 3>> &values) const;

      /** ... and back. */
      void
      turn_out_of_frames(std::vector<Tensor<1, 3>> &values) const;

      /** Set what is fixed to zero, in the frames, ... */
      void
      clear_fixed(std::vector<Tensor<1, 3>> &values) const;

      /** ... or to the motion that remains. */
      void
      set_pending(std::vector<Tensor<1, 3>> &values) const;

      /** Add what remains to be moved to the motion of blocks in space. */
      void
      add_motion(std::vector<Tensor<1, 3>> &values) const;

    private:
      /** That of a constrained block. */
      const Constraint &
      of(const unsigned int block) const
      {
        return constraints[constraint_of_block[block]];
      }

      Tensor<2, 3>
      turned_and_cleared(const unsigned int row,
                         const unsigned int column,
                         Tensor<2, 3>       value) const;

      /** Turn rows and columns of a tangent into the frames of its blocks. */
      void
      turn_into_frames(const unsigned int  n,
                       const unsigned int *blocks,
                       double             *tangent) const;

      /** Call @p action(constraint, value) for the constrained ones. */
      template <typename Action>
      void
      for_each_of(std::vector<Tensor<1, 3>> &values,
                  const Action              &action) const;

      std::vector<Constraint> constraints;
      std::vector<int>        constraint_of_block; /**< -1: it is free */
    };
  } // namespace System
} // namespace Heddle

#endif
