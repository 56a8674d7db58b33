#ifndef heddle_system_diagonal_part_h
#define heddle_system_diagonal_part_h

#include <petscmat.h>

namespace Heddle
{
  namespace System
  {
    /**
     * Writes into the part of an assembled matrix of 3x3 blocks (SBAIJ or BAIJ)
     * that couples the blocks of this rank. What PETSc does for one term, a
     * search for the place of every block, is done once for a row here.
     */
    class DiagonalPart
    {
    public:
      /** Take hold of the part of @p matrix until release(). */
      void
      open(Mat matrix);

      /** @note Does nothing if there is nothing to release. */
      void
      release();

      /**
       * Add to the owned @p row the blocks of its columns @p columns, @p n
       * owned ones in ascending order. Block k is the one at column
       * 3 @p places[k] of the three rows @p values, which are @p stride apart.
       * What a symmetric matrix does not store is left out.
       */
      void
      add_to_row(const unsigned int  row,
                 const unsigned int  n,
                 const unsigned int *columns,
                 const unsigned int *places,
                 const double       *values,
                 const unsigned int  stride);

    private:
      Mat             part      = nullptr;
      PetscBool       symmetric = PETSC_FALSE;
      PetscInt        n_rows    = 0;
      const PetscInt *row_begin = nullptr, *stored = nullptr;
      double         *entries = nullptr;
    };
  } // namespace System
} // namespace Heddle

#endif
