#include <heddle/base/petsc.h>
#include <heddle/solver/cholesky_blocks.h>

#include <array>

namespace Heddle
{
  namespace Solver
  {
    CholeskyBlocks::CholeskyBlocks(
      const std::vector<std::vector<PetscInt>> &columns)
    {
      const PetscInt        n_rows = columns.size(), n = 3 * n_rows;
      std::vector<PetscInt> row_sizes;
      for (const auto &of_row : columns)
        {
          row_sizes.push_back(of_row.size());
          n_stored += of_row.size();
        }
      petsc(MatCreateSeqSBAIJ(
        PETSC_COMM_SELF, 3, n, n, 0, row_sizes.data(), &matrix));
      const std::array<double, size> zeros = {};
      for (PetscInt row = 0; row < n_rows; ++row)
        for (const PetscInt column : columns[row])
          petsc(MatSetValuesBlocked(
            matrix, 1, &row, 1, &column, zeros.data(), INSERT_VALUES));
      petsc(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
      petsc(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));

      IS order;
      petsc(ISCreateStride(PETSC_COMM_SELF, n, 0, 1, &order));
      petsc(ISSetIdentity(order));
      MatFactorInfo how;
      petsc(MatFactorInfoInitialize(&how));
      how.fill = 1.5;
      petsc(MatGetFactor(matrix, MATSOLVERPETSC, MAT_FACTOR_CHOLESKY, &factor));
      petsc(MatCholeskyFactorSymbolic(factor, matrix, order, &how));
      petsc(ISDestroy(&order));
      petsc(VecCreateSeqWithArray(PETSC_COMM_SELF, 3, n, nullptr, &right));
      petsc(VecCreateSeqWithArray(PETSC_COMM_SELF, 3, n, nullptr, &left));
    }



    CholeskyBlocks::~CholeskyBlocks()
    {
      // A destructor throws nothing.
      MatDestroy(&matrix);
      MatDestroy(&factor);
      VecDestroy(&right);
      VecDestroy(&left);
    }



    double *
    CholeskyBlocks::values()
    {
      // They stay where they are when they are given back.
      double *values, *given_back;
      petsc(MatSeqSBAIJGetArray(matrix, &values));
      given_back = values;
      petsc(MatSeqSBAIJRestoreArray(matrix, &given_back));
      return values;
    }



    void
    CholeskyBlocks::factorize()
    {
      MatFactorInfo how;
      petsc(MatFactorInfoInitialize(&how));
      petsc(MatFactorClearError(factor));
      petsc(MatCholeskyFactorNumeric(factor, matrix, &how));
    }



    bool
    CholeskyBlocks::is_positive_definite(const unsigned int row) const
    {
      // Of U^T D U PETSc keeps the inverse blocks of D first, one of each row;
      // by Sylvester's law they are definite if the matrix is. Minors that are
      // no numbers are not positive either.
      double *pivots;
      petsc(MatSeqSBAIJGetArray(factor, &pivots));
      const double *m           = pivots + size * row;
      const double  minor       = m[0] * m[4] - m[3] * m[1];
      const double  determinant = m[8] * minor -
                                 m[7] * (m[0] * m[5] - m[3] * m[2]) +
                                 m[6] * (m[1] * m[5] - m[4] * m[2]);
      const bool positive = m[0] > 0. && minor > 0. && determinant > 0.;
      petsc(MatSeqSBAIJRestoreArray(factor, &pivots));
      return positive;
    }



    PetscErrorCode
    CholeskyBlocks::solve(const double *residual, double *result) const
    {
      PetscErrorCode code = VecPlaceArray(right, residual);
      if (code != 0)
        return code;
      code = VecPlaceArray(left, result);
      if (code == 0)
        code = MatSolve(factor, right, left);
      // Whatever happened: what is placed anew must find nothing in place.
      VecResetArray(left);
      VecResetArray(right);
      return code;
    }
  } // namespace Solver
} // namespace Heddle
