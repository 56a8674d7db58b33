#include <heddle/base/petsc.h>
#include <heddle/solver/fiber_blocks.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

extern "C"
{
  /** LAPACK: Cholesky factorization of a positive definite band. */
  void
  dpbtrf_(const char *uplo,
          const int  *n,
          const int  *kd,
          double     *ab,
          const int  *ldab,
          int        *info);

  /** LAPACK: solution with that factorization. */
  void
  dpbtrs_(const char   *uplo,
          const int    *n,
          const int    *kd,
          const int    *nrhs,
          const double *ab,
          const int    *ldab,
          double       *b,
          const int    *ldb,
          int          *info);
}

namespace Heddle
{
  namespace Solver
  {
    FiberBlocks::FiberBlocks(const System::State &state)
      : state(state)
      // An element couples its own blocks; contact couples the positions of
      // four nodes in a row, or the blocks of one interval.
      , bandwidth(3 * std::max(state.space.element().n_blocks(),
                               state.space.n_blocks_per_node() == 2
                                 ? 4u
                                 : 3 * state.space.n_blocks_per_node() + 1) -
                  1)
    {
    }



    void
    FiberBlocks::set_up(Mat matrix)
    {
      extract(matrix);
      factors          = bands;
      const auto owned = state.space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        factorize(f);
    }



    void
    FiberBlocks::extract(Mat matrix)
    {
      Mat diagonal;
      petsc(MatGetDiagonalBlock(matrix, &diagonal));
      PetscBool symmetric;
      petsc(PetscObjectTypeCompare(
        reinterpret_cast<PetscObject>(diagonal), MATSEQSBAIJ, &symmetric));

      PetscInt        n_rows;
      const PetscInt *row_begin, *columns;
      PetscBool       done;
      petsc(MatGetRowIJ(diagonal,
                        0,
                        PETSC_FALSE,
                        PETSC_TRUE,
                        &n_rows,
                        &row_begin,
                        &columns,
                        &done));
      AssertThrow(done, ExcMessage("The tangent does not show its blocks."));
      double *values;
      if (symmetric)
        petsc(MatSeqSBAIJGetArray(diagonal, &values));
      else
        petsc(MatSeqBAIJGetArray(diagonal, &values));

      const unsigned int height = bandwidth + 1;
      bands.assign(std::size_t(3) * state.n_owned_fiber_blocks() * height, 0.);
      const auto owned = state.space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          const unsigned int begin = state.local_block(f),
                             end   = begin + state.space.n_blocks(f);
          for (unsigned int row = begin; row < end; ++row)
            for (PetscInt k = row_begin[row]; k < row_begin[row + 1]; ++k)
              {
                // The upper triangle; blocks are stored column by column.
                const unsigned int column = columns[k];
                if (column < row || column >= end ||
                    3 * (column - row) + 2 > bandwidth)
                  continue;
                for (unsigned int i = 0; i < 3; ++i)
                  for (unsigned int j = 0; j < 3; ++j)
                    if (column > row || j >= i)
                      bands[std::size_t(3 * row + i) * height +
                            3 * (column - row) + j - i] =
                        values[9 * k + 3 * j + i];
              }
        }

      if (symmetric)
        petsc(MatSeqSBAIJRestoreArray(diagonal, &values));
      else
        petsc(MatSeqBAIJRestoreArray(diagonal, &values));
      petsc(MatRestoreRowIJ(diagonal,
                            0,
                            PETSC_FALSE,
                            PETSC_TRUE,
                            &n_rows,
                            &row_begin,
                            &columns,
                            &done));
    }



    void
    FiberBlocks::factorize(const unsigned int fiber)
    {
      const int n = 3 * state.space.n_blocks(fiber), kd = bandwidth,
                height = bandwidth + 1;
      const std::size_t begin =
        std::size_t(3) * state.local_block(fiber) * height;
      double largest = 0.;
      for (int i = 0; i < n; ++i)
        largest = std::max(largest, std::abs(bands[begin + i * height]));

      // A compressed fiber may be unstable on its own: shift until it is not.
      for (double shift = 0.;; shift = std::max(10. * shift, 1e-8 * largest))
        {
          std::copy_n(bands.begin() + begin,
                      std::size_t(n) * height,
                      factors.begin() + begin);
          for (int i = 0; i < n; ++i)
            factors[begin + i * height] += shift;
          int info;
          dpbtrf_("L", &n, &kd, factors.data() + begin, &height, &info);
          if (info == 0)
            return;
          AssertThrow(shift <= largest && largest > 0.,
                      ExcMessage("The tangent of a fiber is not finite."));
        }
    }



    void
    FiberBlocks::attach_to(PC pc)
    {
      petsc(PCSetType(pc, PCSHELL));
      petsc(PCShellSetContext(pc, this));
      petsc(PCShellSetApply(pc, &FiberBlocks::apply));
      petsc(PCShellSetName(pc, "one banded factorization per fiber"));
    }



    PetscErrorCode
    FiberBlocks::apply(PC pc, Vec residual, Vec result)
    {
      // PETSc calls this: errors are returned, not thrown.
      FiberBlocks   *self;
      double        *values;
      PetscErrorCode code = PCShellGetContext(pc, &self);
      code                = code != 0 ? code : VecCopy(residual, result);
      code                = code != 0 ? code : VecGetArray(result, &values);
      if (code != 0)
        return code;

      const int  kd = self->bandwidth, height = kd + 1, one = 1;
      const auto owned = self->state.space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          const std::size_t begin = std::size_t(3) * self->state.local_block(f);
          const int         n     = 3 * self->state.space.n_blocks(f);
          int               info;
          dpbtrs_("L",
                  &n,
                  &kd,
                  &one,
                  self->factors.data() + begin * height,
                  &height,
                  values + begin,
                  &n,
                  &info);
        }
      return VecRestoreArray(result, &values);
    }
  } // namespace Solver
} // namespace Heddle
