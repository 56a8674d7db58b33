#include <heddle/textile/interpolation.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace Heddle
{
  namespace Textile
  {
    InterpolatedCurve::InterpolatedCurve(
      const std::vector<Tensor<1, 3>> &points,
      const Interpolation              interpolation)
      : points(points)
      , parameters(1, 0.)
      , derivatives(points.size())
    {
      Assert(points.size() >= 2, ExcMessage("A curve needs two points."));
      for (unsigned int i = 1; i < points.size(); ++i)
        {
          parameters.push_back(parameters.back() +
                               (points[i] - points[i - 1]).norm());
          Assert(parameters[i] > parameters[i - 1],
                 ExcMessage("Two points of a curve coincide."));
        }

      if (interpolation == Interpolation::spline)
        compute_spline_derivatives();
      else
        compute_parabola_derivatives();
    }



    void
    InterpolatedCurve::compute_spline_derivatives()
    {
      // Elimination of a tridiagonal system, diagonally dominant: no pivoting.
      const unsigned int  n = points.size();
      std::vector<double> diagonal(n);
      for (unsigned int i = 0; i < n; ++i)
        {
          if (i > 0)
            {
              const double h = chord(i - 1);
              diagonal[i] += 2. / h;
              derivatives[i] += 3. / (h * h) * (points[i] - points[i - 1]);
            }
          if (i + 1 < n)
            {
              const double h = chord(i);
              diagonal[i] += 2. / h;
              derivatives[i] += 3. / (h * h) * (points[i + 1] - points[i]);
            }
          if (i > 0)
            {
              const double factor = 1. / (chord(i - 1) * diagonal[i - 1]);
              diagonal[i] -= factor / chord(i - 1);
              derivatives[i] -= factor * derivatives[i - 1];
            }
        }
      derivatives[n - 1] /= diagonal[n - 1];
      for (unsigned int i = n - 1; i-- > 0;)
        derivatives[i] =
          (derivatives[i] - derivatives[i + 1] / chord(i)) / diagonal[i];
    }



    void
    InterpolatedCurve::compute_parabola_derivatives()
    {
      const unsigned int n     = points.size();
      const auto         slope = [this](const unsigned int i) {
        return (points[i + 1] - points[i]) / chord(i);
      };
      for (unsigned int i = 1; i + 1 < n; ++i)
        derivatives[i] = (chord(i) * slope(i - 1) + chord(i - 1) * slope(i)) /
                         (chord(i - 1) + chord(i));
      if (n == 2)
        derivatives[0] = derivatives[1] = slope(0);
      else
        {
          derivatives[0]     = 2. * slope(0) - derivatives[1];
          derivatives[n - 1] = 2. * slope(n - 2) - derivatives[n - 2];
        }
    }



    Tensor<1, 3>
    InterpolatedCurve::operator()(const double t) const
    {
      const unsigned int i = std::clamp<std::ptrdiff_t>(
        std::upper_bound(parameters.begin(), parameters.end(), t) -
          parameters.begin() - 1,
        0,
        points.size() - 2);
      const double h = chord(i);
      const double s = (t - parameters[i]) / h;
      const double r = 1. - s;
      return r * r * (1. + 2. * s) * points[i] +
             s * s * (1. + 2. * r) * points[i + 1] +
             h * s * r * (r * derivatives[i] - s * derivatives[i + 1]);
    }
  } // namespace Textile
} // namespace Heddle
