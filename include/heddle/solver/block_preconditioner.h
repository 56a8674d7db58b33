#ifndef heddle_solver_block_preconditioner_h
#define heddle_solver_block_preconditioner_h

#include <heddle/solver/fiber_blocks.h>
#include <heddle/solver/matrix_nodes.h>
#include <heddle/solver/yarn_motions.h>

#include <memory>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    /**
     * Preconditioner of conjugate gradients: FiberBlocks for the fibers and
     * MatrixNodes for the matrix, if there is one, plus the coarse correction
     * of YarnMotions. The blocks leave out what couples them, and what couples
     * ranks.
     */
    class BlockPreconditioner
    {
    public:
      BlockPreconditioner(const System::State &state);

      /**
       * Take the blocks from @p system and prepare them, with or without the
       * correction of @p yarn_motions, with a @p gentle shift of fibers that
       * are unstable or not.
       * @note Collective.
       */
      void
      set_up(const System::BlockSystem &system,
             const bool                 yarn_motions,
             const bool                 gentle);

      /** Forget the blocks of the fibers until it is set up anew. */
      void
      forget()
      {
        bands_suffice = false;
        fibers.forget();
      }

      /**
       * The blocks of the fibers, if they are all that the matrix of the system
       * has, on all ranks; else none.
       */
      const FiberBlocks *
      whole_matrix() const
      {
        return bands_suffice ? &fibers : nullptr;
      }

      /** Whether a fiber of this rank is unstable by itself. */
      bool
      has_unstable_fiber() const
      {
        return fibers.has_unstable();
      }

      /** Let @p pc apply this object. */
      void
      attach_to(PC pc);

    private:
      static PetscErrorCode
      apply(PC pc, Vec residual, Vec result);

      const unsigned int           n_fiber_dofs; /**< of this rank */
      FiberBlocks                  fibers;
      YarnMotions                  yarns;
      bool                         bands_suffice = false;
      bool                         corrected     = false;
      std::unique_ptr<MatrixNodes> matrix;
    };
  } // namespace Solver
} // namespace Heddle

#endif
