#include <heddle/base/petsc.h>
#include <heddle/system/diagonal_part.h>

#include <deal.II/base/exceptions.h>

namespace Heddle
{
  namespace System
  {
    void
    DiagonalPart::open(Mat matrix)
    {
      petsc(MatGetDiagonalBlock(matrix, &part));
      petsc(PetscObjectTypeCompare(
        reinterpret_cast<PetscObject>(part), MATSEQSBAIJ, &symmetric));
      PetscBool done;
      petsc(MatGetRowIJ(
        part, 0, PETSC_FALSE, PETSC_TRUE, &n_rows, &row_begin, &stored, &done));
      AssertThrow(done,
                  dealii::ExcMessage("The tangent does not show its blocks."));
      if (symmetric)
        petsc(MatSeqSBAIJGetArray(part, &entries));
      else
        petsc(MatSeqBAIJGetArray(part, &entries));
    }



    void
    DiagonalPart::release()
    {
      if (part == nullptr)
        return;
      if (symmetric)
        petsc(MatSeqSBAIJRestoreArray(part, &entries));
      else
        petsc(MatSeqBAIJRestoreArray(part, &entries));
      PetscBool done;
      petsc(MatRestoreRowIJ(
        part, 0, PETSC_FALSE, PETSC_TRUE, &n_rows, &row_begin, &stored, &done));
      part = nullptr;
    }



    void
    DiagonalPart::add_to_row(const unsigned int  row,
                             const unsigned int  n,
                             const unsigned int *columns,
                             const unsigned int *places,
                             const double       *values,
                             const unsigned int  stride)
    {
      PetscInt k = row_begin[row];
      for (unsigned int c = 0; c < n; ++c)
        {
          const PetscInt column = columns[c];
          if (symmetric && columns[c] < row)
            continue;
          while (k < row_begin[row + 1] && stored[k] < column)
            ++k;
          AssertThrow(k < row_begin[row + 1] && stored[k] == column,
                      dealii::ExcMessage("The pattern lacks a block."));
          double       *block = entries + 9 * k;
          const double *value = values + 3 * places[c];
          for (unsigned int j = 0; j < 3; ++j)
            for (unsigned int i = 0; i < 3; ++i)
              block[3 * j + i] += value[stride * i + j];
        }
    }
  } // namespace System
} // namespace Heddle
