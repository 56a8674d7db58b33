#include <heddle/textile/parametric_curve.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace Heddle
{
  namespace Textile
  {
    Knots
    equally_spaced(const ParametricCurve &curve,
                   const double           begin,
                   const double           end,
                   const unsigned int     n_points,
                   const unsigned int     n_samples)
    {
      Assert(n_points >= 2 && n_samples >= 1,
             ExcMessage("A curve needs two knots and one sample."));

      const double        step = (end - begin) / n_samples;
      std::vector<double> lengths(1, 0.);
      Tensor<1, 3>        previous = curve(begin);
      for (unsigned int i = 1; i <= n_samples; ++i)
        {
          const Tensor<1, 3> next = curve(begin + i * step);
          lengths.push_back(lengths.back() + (next - previous).norm());
          previous = next;
        }

      Knots knots;
      knots.length = lengths.back();
      for (unsigned int k = 0; k < n_points; ++k)
        {
          const double       target = knots.length * k / (n_points - 1);
          const unsigned int next   = std::clamp<std::ptrdiff_t>(
            std::lower_bound(lengths.begin(), lengths.end(), target) -
              lengths.begin(),
            1,
            n_samples);
          const double part =
            (target - lengths[next - 1]) / (lengths[next] - lengths[next - 1]);
          knots.points.push_back(curve(begin + (next - 1 + part) * step));
        }
      return knots;
    }
  } // namespace Textile
} // namespace Heddle
