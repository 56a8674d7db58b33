#include <heddle/base/normals.h>

#include <cmath>

namespace Heddle
{
  std::array<Tensor<1, 3>, 2>
  two_normals(const Tensor<1, 3> &direction)
  {
    unsigned int farthest = 0;
    for (unsigned int d = 1; d < 3; ++d)
      if (std::abs(direction[d]) < std::abs(direction[farthest]))
        farthest = d;
    Tensor<1, 3> axis;
    axis[farthest] = 1.;

    const Tensor<1, 3> unit  = direction / direction.norm();
    Tensor<1, 3>       first = cross_product_3d(unit, axis);
    first /= first.norm();
    return {{first, cross_product_3d(unit, first)}};
  }
} // namespace Heddle
