#ifndef heddle_system_local_blocks_h
#define heddle_system_local_blocks_h

#include <petscmat.h>

namespace Heddle
{
  namespace System
  {
    /**
     * What an assembled symmetric matrix of 3x3 blocks (SBAIJ) holds between
     * the blocks of this rank, to be read and written in place as long as this
     * object lives. What PETSc does for one term, a search for the place of
     * every block, is done once for a row here.
     */
    class LocalBlocks
    {
    public:
      LocalBlocks(Mat matrix);

      ~LocalBlocks();

      LocalBlocks(const LocalBlocks &) = delete;
      LocalBlocks &
      operator=(const LocalBlocks &) = delete;

      /**
       * Call @p action(column, values) for the blocks of row @p row from the
       * diagonal on, in ascending order; the nine values go column by column.
       */
      template <typename Action>
      void
      for_each_of_upper_row(const unsigned int row, const Action &action) const
      {
        for (PetscInt k = row_begin[row]; k < row_begin[row + 1]; ++k)
          action(static_cast<unsigned int>(stored[k]), values + 9 * k);
      }

      /**
       * Add to the owned @p row the blocks of its columns @p columns, @p n
       * owned ones in ascending order. Block k is the one at column
       * 3 @p places[k] of the three rows @p added, which are @p stride apart.
       * What lies below the diagonal is left out.
       */
      void
      add_to_row(const unsigned int  row,
                 const unsigned int  n,
                 const unsigned int *columns,
                 const unsigned int *places,
                 const double       *added,
                 const unsigned int  stride);

    private:
      Mat             part;
      PetscInt        n_rows;
      const PetscInt *row_begin, *stored;
      double         *values;
    };
  } // namespace System
} // namespace Heddle

#endif
