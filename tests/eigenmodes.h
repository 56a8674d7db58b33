#ifndef heddle_tests_eigenmodes_h
#define heddle_tests_eigenmodes_h

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <utility>

using namespace dealii;

/**
 * Eigenvalues of a symmetric matrix, smallest first, and its eigenvectors, one
 * in each column. By LAPACK: Eigen's solver takes longer to compile than all
 * that is tested with it.
 */
inline std::pair<Vector<double>, FullMatrix<double>>
eigenmodes(LAPACKFullMatrix<double> matrix)
{
  const double       beyond_all = 2. * matrix.frobenius_norm();
  Vector<double>     values;
  FullMatrix<double> vectors;
  matrix.compute_eigenvalues_symmetric(-beyond_all,
                                       beyond_all,
                                       /*abs_accuracy=*/0.,
                                       values,
                                       vectors);
  return {values, vectors};
}

#endif
