#include <heddle/contributions/volume_in_box.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Heddle
{
  namespace Contributions
  {
    namespace
    {
      /** Straight pieces of an axis within one radius: of one that is bent to
       * ten times its radius the length is short by 3e-5. */
      constexpr double pieces_per_radius = 4.;



      /** Length of the straight piece from @p a to @p b in @p box [mm]. */
      double
      length_in_box(const Tensor<1, 3>   &a,
                    const Tensor<1, 3>   &b,
                    const BoundingBox<3> &box)
      {
        const Tensor<1, 3> piece = b - a;
        double             from = 0., to = 1.;
        for (unsigned int d = 0; d < 3; ++d)
          {
            const double low  = box.lower_bound(d) - a[d];
            const double high = box.upper_bound(d) - a[d];
            if (piece[d] != 0.)
              {
                from =
                  std::max(from, std::min(low / piece[d], high / piece[d]));
                to = std::min(to, std::max(low / piece[d], high / piece[d]));
              }
            else if (low > 0. || high < 0.)
              return 0.;
          }
        return std::max(0., to - from) * piece.norm();
      }
    } // namespace



    double
    volume_in_box(const System::State &state, const BoundingBox<3> &box)
    {
      const System::FiberSpace &space  = state.space;
      const auto                owned  = space.owned_fibers();
      double                    volume = 0.;
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          const System::Fiber &fiber = space.fiber(f);
          const double *const  s     = space.node_positions(f);
          Tensor<1, 3> before = space.locate(f, 0.).position(state.fiber(f));
          double       length = 0.;
          for (unsigned int i = 0; i + 1 < fiber.n_nodes; ++i)
            {
              const unsigned int n =
                std::ceil(pieces_per_radius * (s[i + 1] - s[i]) / fiber.radius);
              for (unsigned int k = 1; k <= n; ++k)
                {
                  const double       at = s[i] + (s[i + 1] - s[i]) * k / n;
                  const Tensor<1, 3> now =
                    space.locate(f, at).position(state.fiber(f));
                  length += length_in_box(before, now, box);
                  before = now;
                }
            }
          volume += numbers::PI * fiber.radius * fiber.radius * length;
        }
      return volume;
    }
  } // namespace Contributions
} // namespace Heddle
