#include <heddle/base/petsc.h>
#include <heddle/solver/block_preconditioner.h>

#include <deal.II/base/mpi.h>

namespace Heddle
{
  namespace Solver
  {
    BlockPreconditioner::BlockPreconditioner(const System::State &state)
      : n_fiber_dofs(3 * state.n_owned_fiber_blocks())
      , fibers(state)
      , yarns(state)
    {
      if (state.matrix())
        matrix = std::make_unique<MatrixNodes>(state);
    }



    void
    BlockPreconditioner::set_up(const System::BlockSystem &system,
                                const bool                 yarn_motions,
                                const bool                 gentle)
    {
      const System::LocalBlocks blocks(system.tangent());
      fibers.set_up(blocks, gentle);
      bands_suffice =
        !system.couples_ranks() &&
        Utilities::MPI::min(fibers.are_all() ? 1 : 0,
                            system.state.space.communicator()) > 0;
      corrected = yarn_motions;
      if (corrected)
        yarns.set_up(system, blocks);
      if (matrix)
        matrix->set_up(blocks);
    }



    void
    BlockPreconditioner::attach_to(PC pc)
    {
      petsc(PCSetType(pc, PCSHELL));
      petsc(PCShellSetContext(pc, this));
      petsc(PCShellSetApply(pc, &BlockPreconditioner::apply));
      petsc(PCShellSetName(pc, "fiber blocks"));
    }



    PetscErrorCode
    BlockPreconditioner::apply(PC pc, Vec residual, Vec result)
    {
      // PETSc calls this: errors are returned, not thrown.
      BlockPreconditioner *self;
      const double        *input;
      double              *output;
      PetscErrorCode       code = PCShellGetContext(pc, &self);
      code = code != 0 ? code : VecGetArrayRead(residual, &input);
      code = code != 0 ? code : VecGetArray(result, &output);
      if (code != 0)
        return code;
      const unsigned int n = self->n_fiber_dofs;
      self->fibers.apply(input, output);
      if (self->matrix)
        self->matrix->apply(input + n, output + n);
      if (self->corrected)
        code = code != 0 ? code : self->yarns.add_correction(input, output);
      code = code != 0 ? code : VecRestoreArray(result, &output);
      return code != 0 ? code : VecRestoreArrayRead(residual, &input);
    }
  } // namespace Solver
} // namespace Heddle
