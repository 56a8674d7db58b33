#include <heddle/solver/matrix_nodes.h>

namespace Heddle
{
  namespace Solver
  {
    MatrixNodes::MatrixNodes(const System::State &state)
      : state(state)
    {
    }



    void
    MatrixNodes::set_up(const System::LocalBlocks &tangent)
    {
      inverses.clear();
      for (unsigned int row = state.n_owned_fiber_blocks();
           row < state.n_owned_blocks();
           ++row)
        tangent.for_each_of_upper_row(
          row, [&](const unsigned int column, const double *values) {
            if (column != row)
              return;
            SymmetricTensor<2, 3> block;
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int j = i; j < 3; ++j)
                block[i][j] = values[3 * j + i];
            inverses.push_back(invert(block));
          });
    }



    void
    MatrixNodes::apply(const double *residual, double *result) const
    {
      for (const SymmetricTensor<2, 3> &inverse : inverses)
        {
          const Tensor<1, 3> motion =
            inverse * Tensor<1, 3>({residual[0], residual[1], residual[2]});
          for (unsigned int i = 0; i < 3; ++i)
            result[i] = motion[i];
          residual += 3;
          result += 3;
        }
    }
  } // namespace Solver
} // namespace Heddle
