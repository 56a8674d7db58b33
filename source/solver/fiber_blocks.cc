#include <heddle/base/petsc.h>
#include <heddle/solver/fiber_blocks.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /** Numbers of a block. */
      constexpr unsigned int size = 9;

      /** First shift of an unstable fiber, over its largest entry. */
      constexpr double first_shift = 1e-8;



      bool
      is_zero(const double *block)
      {
        return std::all_of(
          block, block + size, [](const double value) { return value == 0.; });
      }



      /** By leading minors; not if a number is none. */
      bool
      is_positive_definite(const double *m)
      {
        const double minor       = m[0] * m[4] - m[3] * m[1];
        const double determinant = m[8] * minor -
                                   m[7] * (m[0] * m[5] - m[3] * m[2]) +
                                   m[6] * (m[1] * m[5] - m[4] * m[2]);
        return m[0] > 0. && minor > 0. && determinant > 0.;
      }
    } // namespace



    FiberBlocks::FiberBlocks(const System::State &state)
      : state(state)
      // An element couples its own blocks; contact couples the positions of
      // four nodes in a row, or the blocks of one interval.
      , n_offsets(std::max(state.space.element().n_blocks(),
                           state.space.n_blocks_per_node() == 2
                             ? 4u
                             : 3 * state.space.n_blocks_per_node() + 1))
      , coupled(state.space.n_blocks_per_node(),
                std::vector<bool>(n_offsets, false))
    {
      for (std::vector<bool> &of_kind : coupled)
        of_kind[0] = true;
    }



    FiberBlocks::~FiberBlocks()
    {
      clear();
    }



    void
    FiberBlocks::clear()
    {
      // All of them may be empty, and a destructor throws nothing.
      MatDestroy(&matrix);
      MatDestroy(&factor);
      VecDestroy(&right);
      VecDestroy(&left);
    }



    void
    FiberBlocks::set_up(const System::LocalBlocks &tangent)
    {
      if (state.n_owned_fiber_blocks() == 0)
        return;
      if (find_couplings(tangent) || matrix == nullptr)
        create();

      double *values;
      petsc(MatSeqSBAIJGetArray(matrix, &values));
      std::fill_n(values, size * row_begin.back(), 0.);
      for_each_block(tangent,
                     [&](const unsigned int row,
                         const unsigned int offset,
                         const double      *block) {
                       if (coupled[kind(row)][offset])
                         std::copy_n(
                           block, size, values + size * position(row, offset));
                     });
      petsc(MatSeqSBAIJRestoreArray(matrix, &values));

      // A compressed fiber may be unstable on its own: shift until it is not.
      MatFactorInfo how;
      petsc(MatFactorInfoInitialize(&how));
      for (double shifted = 0.;;)
        {
          petsc(MatFactorClearError(factor));
          petsc(MatCholeskyFactorNumeric(factor, matrix, &how));
          const std::vector<unsigned int> unstable = find_unstable();
          if (unstable.empty())
            return;
          AssertThrow(shifted <= 1.,
                      ExcMessage("The tangent of a fiber is not finite."));
          const double next = std::max(10. * shifted, first_shift);
          for (const unsigned int f : unstable)
            shift(f, shifted, next);
          shifted = next;
        }
    }



    PetscErrorCode
    FiberBlocks::apply(const double *residual, double *result) const
    {
      if (state.n_owned_fiber_blocks() == 0)
        return 0;
      PetscErrorCode code = VecPlaceArray(right, residual);
      code                = code != 0 ? code : VecPlaceArray(left, result);
      code                = code != 0 ? code : MatSolve(factor, right, left);
      code                = code != 0 ? code : VecResetArray(right);
      return code != 0 ? code : VecResetArray(left);
    }



    template <typename Action>
    void
    FiberBlocks::for_each_block(const System::LocalBlocks &tangent,
                                const Action              &action) const
    {
      const auto owned = state.space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          const auto held = state.held_blocks(f);
          for (unsigned int row = held.first; row < held.second; ++row)
            tangent.for_each_of_upper_row(
              row, [&](const unsigned int column, const double *block) {
                if (column < held.second && column - row < n_offsets)
                  action(row, column - row, block);
              });
        }
    }



    bool
    FiberBlocks::find_couplings(const System::LocalBlocks &tangent)
    {
      bool more = false;
      for_each_block(tangent,
                     [&](const unsigned int row,
                         const unsigned int offset,
                         const double      *block) {
                       if (!coupled[kind(row)][offset] && !is_zero(block))
                         {
                           coupled[kind(row)][offset] = true;
                           more                       = true;
                         }
                     });
      return more;
    }



    void
    FiberBlocks::create()
    {
      clear();
      rank_of_offset.assign(coupled.size(),
                            std::vector<unsigned int>(n_offsets + 1, 0));
      for (unsigned int k = 0; k < coupled.size(); ++k)
        for (unsigned int offset = 0; offset < n_offsets; ++offset)
          rank_of_offset[k][offset + 1] =
            rank_of_offset[k][offset] + (coupled[k][offset] ? 1 : 0);

      const unsigned int    n_rows = state.n_owned_fiber_blocks();
      std::vector<PetscInt> row_sizes(n_rows);
      row_begin.assign(1, 0);
      const auto owned = state.space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          const auto held = state.held_blocks(f);
          for (unsigned int row = held.first; row < held.second; ++row)
            {
              row_sizes[row] =
                rank_of_offset[kind(row)]
                              [std::min(n_offsets, held.second - row)];
              row_begin.push_back(row_begin.back() + row_sizes[row]);
            }
        }

      const PetscInt n = 3 * n_rows;
      petsc(MatCreateSeqSBAIJ(
        PETSC_COMM_SELF, 3, n, n, 0, row_sizes.data(), &matrix));
      const std::array<double, size> zeros = {};
      for (PetscInt row = 0; row < PetscInt(n_rows); ++row)
        for (PetscInt offset = 0, k = 0; k < row_sizes[row]; ++offset)
          if (coupled[kind(row)][offset])
            {
              const PetscInt column = row + offset;
              petsc(MatSetValuesBlocked(
                matrix, 1, &row, 1, &column, zeros.data(), INSERT_VALUES));
              ++k;
            }
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



    void
    FiberBlocks::shift(const unsigned int fiber,
                       const double       before,
                       const double       after)
    {
      double *values;
      petsc(MatSeqSBAIJGetArray(matrix, &values));
      const auto held              = state.held_blocks(fiber);
      double     largest           = 0.;
      const auto for_each_diagonal = [&](const auto &action) {
        for (unsigned int row = held.first; row < held.second; ++row)
          for (unsigned int d = 0; d < 3; ++d)
            action(values[size * position(row, 0) + 4 * d]);
      };
      for_each_diagonal([&largest](const double value) {
        largest = std::max(largest, std::abs(value));
      });

      // What was added last is in the largest one, too.
      largest /= 1. + before;
      for_each_diagonal(
        [&](double &value) { value += (after - before) * largest; });
      petsc(MatSeqSBAIJRestoreArray(matrix, &values));
    }



    std::vector<unsigned int>
    FiberBlocks::find_unstable() const
    {
      // Of U^T D U PETSc keeps the inverse blocks of D first, one of each row;
      // by Sylvester's law they are definite if the matrix is.
      std::vector<unsigned int> unstable;
      const auto                owned = state.space.owned_fibers();
      double                   *inverse_pivots;
      petsc(MatSeqSBAIJGetArray(factor, &inverse_pivots));
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          const auto held = state.held_blocks(f);
          for (unsigned int row = held.first; row < held.second; ++row)
            if (!is_positive_definite(inverse_pivots + size * row))
              {
                unstable.push_back(f);
                break;
              }
        }
      petsc(MatSeqSBAIJRestoreArray(factor, &inverse_pivots));
      return unstable;
    }
  } // namespace Solver
} // namespace Heddle
