#include <heddle/coupling/section_link.h>

#include <algorithm>

namespace Heddle
{
  namespace Coupling
  {
    SectionLink::Pair
    SectionLink::vectors(const Tensor<1, 3> *places) const
    {
      Pair g;
      for (unsigned int b = 0; b < n_of_fiber; ++b)
        g[b % 2] += weights[b / 2] * places[b];
      return g;
    }



    SectionLink::Pair
    SectionLink::carried(const Tensor<1, 3> *places) const
    {
      Pair m;
      for (unsigned int b = n_of_fiber; b < n; ++b)
        for (unsigned int alpha = 0; alpha < 2; ++alpha)
          m[alpha] += slopes[b - n_of_fiber][alpha] * places[b];
      return m;
    }



    double
    SectionLink::turn(const Tensor<1, 3> *places) const
    {
      const Pair g = vectors(places), m = carried(places);
      return 0.5 * (m[1] * g[0] - m[0] * g[1]);
    }



    double
    SectionLink::assemble(const Tensor<1, 3> *places,
                          double             *residual,
                          double             *tangent) const
    {
      const Pair   g = vectors(places), m = carried(places);
      const double s = 0.5 * (m[1] * g[0] - m[0] * g[1]);

      // The derivative of s, for now in place of the residual.
      for (unsigned int b = 0; b < n; ++b)
        {
          Tensor<1, 3> derivative;
          if (b < n_of_fiber)
            derivative =
              0.5 * weights[b / 2] * (b % 2 == 0 ? m[1] : -1. * m[0]);
          else
            {
              const auto &slope = slopes[b - n_of_fiber];
              derivative        = 0.5 * (slope[1] * g[0] - slope[0] * g[1]);
            }
          std::copy(
            derivative.begin_raw(), derivative.end_raw(), residual + 3 * b);
        }

      const unsigned int size = 3 * n;
      if (tangent)
        {
          for (unsigned int i = 0; i < size; ++i)
            for (unsigned int j = 0; j < size; ++j)
              tangent[i * size + j] = stiffness * residual[i] * residual[j];

          // s is linear in the vectors of the fiber, and in the nodes.
          for (unsigned int b = 0; b < n_of_fiber; ++b)
            for (unsigned int a = n_of_fiber; a < n; ++a)
              {
                const auto  &slope  = slopes[a - n_of_fiber];
                const double second = 0.5 * stiffness * s * weights[b / 2] *
                                      (b % 2 == 0 ? slope[1] : -slope[0]);
                for (unsigned int d = 0; d < 3; ++d)
                  {
                    tangent[(3 * b + d) * size + 3 * a + d] += second;
                    tangent[(3 * a + d) * size + 3 * b + d] += second;
                  }
              }
        }
      for (unsigned int i = 0; i < size; ++i)
        residual[i] *= stiffness * s;
      return 0.5 * stiffness * s * s;
    }
  } // namespace Coupling
} // namespace Heddle
