#include <heddle/base/petsc.h>
#include <heddle/solver/local_blocks.h>

#include <deal.II/base/exceptions.h>

namespace Heddle
{
  namespace Solver
  {
    LocalBlocks::LocalBlocks(Mat tangent)
    {
      petsc(MatGetDiagonalBlock(tangent, &diagonal));
      petsc(PetscObjectTypeCompare(
        reinterpret_cast<PetscObject>(diagonal), MATSEQSBAIJ, &symmetric));
      PetscBool done;
      petsc(MatGetRowIJ(diagonal,
                        0,
                        PETSC_FALSE,
                        PETSC_TRUE,
                        &n_rows,
                        &row_begin,
                        &columns,
                        &done));
      AssertThrow(done,
                  dealii::ExcMessage("The tangent does not show its blocks."));
      if (symmetric)
        petsc(MatSeqSBAIJGetArray(diagonal, &values));
      else
        petsc(MatSeqBAIJGetArray(diagonal, &values));
    }



    LocalBlocks::~LocalBlocks()
    {
      // Nothing was written: what PETSc returns says nothing.
      PetscBool done;
      if (symmetric)
        MatSeqSBAIJRestoreArray(diagonal, &values);
      else
        MatSeqBAIJRestoreArray(diagonal, &values);
      MatRestoreRowIJ(diagonal,
                      0,
                      PETSC_FALSE,
                      PETSC_TRUE,
                      &n_rows,
                      &row_begin,
                      &columns,
                      &done);
    }
  } // namespace Solver
} // namespace Heddle
