#ifndef heddle_solver_local_blocks_h
#define heddle_solver_local_blocks_h

#include <petscmat.h>

namespace Heddle
{
  namespace Solver
  {
    /**
     * View of what a tangent of 3x3 blocks (SBAIJ or BAIJ) holds between the
     * blocks of this rank. Values may be read as long as the view lives.
     */
    class LocalBlocks
    {
    public:
      LocalBlocks(Mat tangent);

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
          if (static_cast<unsigned int>(columns[k]) >= row)
            action(static_cast<unsigned int>(columns[k]), values + 9 * k);
      }

    private:
      Mat             diagonal;
      PetscBool       symmetric;
      PetscInt        n_rows;
      const PetscInt *row_begin, *columns;
      double         *values;
    };
  } // namespace Solver
} // namespace Heddle

#endif
