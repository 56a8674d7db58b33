#include <heddle/base/petsc.h>
#include <heddle/solver/tangent_operator.h>

namespace Heddle
{
  namespace Solver
  {
    TangentOperator::TangentOperator(const System::BlockSystem      &system,
                                     const System::BlockSystem::Part part)
      : system(system)
      , part(part)
    {
      const PetscInt n_owned = 3 * system.state.n_owned_blocks();
      petsc(MatCreateShell(system.state.space.communicator(),
                           n_owned,
                           n_owned,
                           PETSC_DETERMINE,
                           PETSC_DETERMINE,
                           this,
                           &shell));
      petsc(MatShellSetOperation(
        shell,
        MATOP_MULT,
        reinterpret_cast<void (*)()>(&TangentOperator::multiply)));
    }



    TangentOperator::~TangentOperator()
    {
      MatDestroy(&shell);
    }



    PetscErrorCode
    TangentOperator::multiply(Mat shell, Vec vector, Vec product)
    {
      // PETSc calls this: errors are returned, not thrown.
      TangentOperator *self;
      const double    *input;
      double          *output;
      PetscErrorCode   code = MatShellGetContext(shell, &self);
      if (code == 0 && !self->bands)
        code = MatMult(self->system.tangent(), vector, product);
      code = code != 0 ? code : VecGetArrayRead(vector, &input);
      code = code != 0 ? code : VecGetArray(product, &output);
      if (code != 0)
        return code;
      if (self->bands)
        self->bands->multiply(input, output);
      self->system.add_product_of_terms(self->part, input, output);
      code = VecRestoreArray(product, &output);
      return code != 0 ? code : VecRestoreArrayRead(vector, &input);
    }
  } // namespace Solver
} // namespace Heddle
