#ifndef heddle_base_petsc_h
#define heddle_base_petsc_h

#include <deal.II/base/exceptions.h>
#include <deal.II/lac/exceptions.h>

#include <petscsys.h>

namespace Heddle
{
  /** Throws ExcPETScError if the PETSc function that gave @p code failed. */
  inline void
  petsc(const PetscErrorCode code)
  {
    AssertThrow(code == 0, dealii::LACExceptions::ExcPETScError(code));
  }
} // namespace Heddle

#endif
