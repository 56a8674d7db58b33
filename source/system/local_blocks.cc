#include <heddle/base/petsc.h>
#include <heddle/system/local_blocks.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace Heddle
{
  namespace System
  {
    LocalBlocks::LocalBlocks(Mat matrix)
    {
      petsc(MatGetDiagonalBlock(matrix, &part));
      PetscBool done;
      petsc(MatGetRowIJ(
        part, 0, PETSC_FALSE, PETSC_TRUE, &n_rows, &row_begin, &stored, &done));
      AssertThrow(done,
                  dealii::ExcMessage("The tangent does not show its blocks."));
      petsc(MatSeqSBAIJGetArray(part, &values));
    }



    LocalBlocks::~LocalBlocks()
    {
      // A destructor throws nothing, and views that end cannot fail.
      PetscBool done;
      MatSeqSBAIJRestoreArray(part, &values);
      MatRestoreRowIJ(
        part, 0, PETSC_FALSE, PETSC_TRUE, &n_rows, &row_begin, &stored, &done);
    }



    void
    LocalBlocks::add_to_row(const unsigned int  row,
                            const unsigned int  n,
                            const unsigned int *columns,
                            const unsigned int *places,
                            const double       *added,
                            const unsigned int  stride)
    {
      PetscInt k = row_begin[row];
      for (unsigned int c = 0; c < n; ++c)
        {
          const PetscInt column = columns[c];
          if (columns[c] < row)
            continue;
          while (k < row_begin[row + 1] && stored[k] < column)
            ++k;
          AssertThrow(k < row_begin[row + 1] && stored[k] == column,
                      dealii::ExcMessage("The pattern lacks a block."));
          double       *block = values + 9 * k;
          const double *value = added + 3 * places[c];

          // Summed first, for the compiler does not know that they are apart.
          double sums[9];
          for (unsigned int j = 0; j < 3; ++j)
            for (unsigned int i = 0; i < 3; ++i)
              sums[3 * j + i] = block[3 * j + i] + value[stride * i + j];
          std::copy_n(sums, 9, block);
        }
    }
  } // namespace System
} // namespace Heddle
