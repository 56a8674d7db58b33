#ifndef heddle_base_normals_h
#define heddle_base_normals_h

#include <deal.II/base/tensor.h>

#include <array>

namespace Heddle
{
  using namespace dealii;

  /**
   * Two unit vectors $n_1, n_2$ normal to @p direction, of any length but zero,
   * and to each other; with the direction they are right-handed. $n_1$ is also
   * normal to the axis of space that the direction is farthest from.
   */
  std::array<Tensor<1, 3>, 2>
  two_normals(const Tensor<1, 3> &direction);
} // namespace Heddle

#endif
