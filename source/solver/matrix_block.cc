#include <heddle/base/petsc.h>
#include <heddle/solver/matrix_block.h>

#include <vector>

namespace Heddle
{
  namespace Solver
  {
    MatrixBlock::MatrixBlock(const System::State &state)
      : state(state)
    {
      const PetscInt size =
        3 * (state.n_owned_blocks() - state.n_owned_fiber_blocks());
      petsc(VecCreateSeqWithArray(PETSC_COMM_SELF, 3, size, nullptr, &input));
      petsc(VecCreateSeqWithArray(PETSC_COMM_SELF, 3, size, nullptr, &output));
    }



    MatrixBlock::~MatrixBlock()
    {
      clear();
      VecDestroy(&input);
      VecDestroy(&output);
    }



    void
    MatrixBlock::clear()
    {
      PCDestroy(&pc);
      MatDestroy(&block);
    }



    void
    MatrixBlock::set_up(const System::LocalBlocks &tangent)
    {
      // The pattern may have changed: all is made anew, which costs next to
      // nothing.
      clear();
      const unsigned int first   = state.n_owned_fiber_blocks(),
                         end     = state.n_owned_blocks();
      const PetscInt        size = 3 * (end - first);
      std::vector<PetscInt> row_lengths(end - first, 0);
      for (unsigned int row = first; row < end; ++row)
        tangent.for_each_of_upper_row(
          row, [&](const unsigned int column, const double *) {
            ++row_lengths[row - first];
            if (column > row)
              ++row_lengths[column - first];
          });
      petsc(MatCreateSeqBAIJ(
        PETSC_COMM_SELF, 3, size, size, 0, row_lengths.data(), &block));

      // A sweep needs both triangles. PETSc reads blocks row by row: those of
      // the tangent are then transposed ones.
      for (unsigned int row = first; row < end; ++row)
        tangent.for_each_of_upper_row(
          row, [&](const unsigned int column, const double *values) {
            const PetscInt here = row - first, there = column - first;
            const double   transposed[9] = {values[0],
                                            values[3],
                                            values[6],
                                            values[1],
                                            values[4],
                                            values[7],
                                            values[2],
                                            values[5],
                                            values[8]};
            petsc(MatSetValuesBlocked(
              block, 1, &here, 1, &there, transposed, INSERT_VALUES));
            if (column > row)
              petsc(MatSetValuesBlocked(
                block, 1, &there, 1, &here, values, INSERT_VALUES));
          });
      petsc(MatAssemblyBegin(block, MAT_FINAL_ASSEMBLY));
      petsc(MatAssemblyEnd(block, MAT_FINAL_ASSEMBLY));

      petsc(PCCreate(PETSC_COMM_SELF, &pc));
      petsc(PCSetOptionsPrefix(pc, "matrix_block_"));
      petsc(PCSetType(pc, PCSOR));
      petsc(PCSORSetSymmetric(pc, SOR_LOCAL_SYMMETRIC_SWEEP));
      petsc(PCSetOperators(pc, block, block));
      petsc(PCSetFromOptions(pc));
      petsc(PCSetUp(pc));
    }



    PetscErrorCode
    MatrixBlock::apply(const double *residual, double *result) const
    {
      PetscErrorCode code = VecPlaceArray(input, residual);
      if (code != 0)
        return code;
      code = VecPlaceArray(output, result);
      if (code == 0)
        code = PCApply(pc, input, output);
      // Whatever happened: what is placed anew must find nothing in place.
      VecResetArray(output);
      VecResetArray(input);
      return code;
    }
  } // namespace Solver
} // namespace Heddle
