#ifndef heddle_solver_matrix_nodes_h
#define heddle_solver_matrix_nodes_h

#include <heddle/system/local_blocks.h>
#include <heddle/system/state.h>

#include <deal.II/base/symmetric_tensor.h>

#include <vector>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    /**
     * Approximate inverse of what the tangent holds between the nodes of the
     * matrix of this rank: that of every node by itself. Better ones, such as
     * sweeps of Gauss and Seidel or multigrid, save fewer iterations than they
     * cost, for what takes long are fibers in contact (doc/what_was_tried.md).
     */
    class MatrixNodes
    {
    public:
      MatrixNodes(const System::State &state);

      /** Take this part of a tangent. */
      void
      set_up(const System::LocalBlocks &tangent);

      /**
       * Write to @p result what @p residual gives, for the own nodes of the
       * matrix.
       */
      void
      apply(const double *residual, double *result) const;

    private:
      const System::State               &state;
      std::vector<SymmetricTensor<2, 3>> inverses;
    };
  } // namespace Solver
} // namespace Heddle

#endif
