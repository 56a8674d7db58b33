#include <heddle/coupling/link.h>

#include <algorithm>

namespace Heddle
{
  namespace Coupling
  {
    Tensor<1, 3>
    Link::stretch(const Tensor<1, 3> *places) const
    {
      Tensor<1, 3> distance = -offset;
      for (unsigned int a = 0; a < n; ++a)
        distance += weights[a] * places[a];
      return distance;
    }



    double
    Link::assemble(const Tensor<1, 3> *places,
                   double             *residual,
                   double             *tangent) const
    {
      const Tensor<1, 3> distance = stretch(places);
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int d = 0; d < 3; ++d)
          residual[3 * a + d] = stiffness * weights[a] * distance[d];
      if (tangent)
        {
          std::fill_n(tangent, 9 * n * n, 0.);
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int b = 0; b < n; ++b)
              for (unsigned int d = 0; d < 3; ++d)
                tangent[(3 * a + d) * 3 * n + 3 * b + d] =
                  stiffness * weights[a] * weights[b];
        }
      return 0.5 * stiffness * distance.norm_square();
    }
  } // namespace Coupling
} // namespace Heddle
