#ifndef heddle_solver_block_preconditioner_h
#define heddle_solver_block_preconditioner_h

#include <heddle/solver/fiber_blocks.h>
#include <heddle/solver/matrix_block.h>

#include <memory>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    /**
     * Preconditioner of conjugate gradients: FiberBlocks for the fibers and
     * MatrixBlock for the matrix, if there is one. What couples them is left
     * out, as is what couples ranks.
     */
    class BlockPreconditioner
    {
    public:
      BlockPreconditioner(const System::State &state);

      /** Take the blocks from @p tangent and prepare them. */
      void
      set_up(Mat tangent);

      /** Let @p pc apply this object. */
      void
      attach_to(PC pc);

    private:
      static PetscErrorCode
      apply(PC pc, Vec residual, Vec result);

      const unsigned int           n_fiber_dofs; /**< of this rank */
      FiberBlocks                  fibers;
      std::unique_ptr<MatrixBlock> matrix;
    };
  } // namespace Solver
} // namespace Heddle

#endif
