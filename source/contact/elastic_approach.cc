#include <heddle/contact/elastic_approach.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Heddle
{
  namespace Contact
  {
    using namespace dealii;

    namespace internal
    {
      namespace ElasticApproach
      {
        /** Complete elliptic integrals K and E, and K - E without loss. */
        struct EllipticIntegrals
        {
          double first, second, difference;
        };



        /** By the arithmetic and geometric mean; @p k is sqrt(1 - e^2). */
        EllipticIntegrals
        integrals(const double k)
        {
          double mean = 1., other = k, sum = 0.5 * (1. - k * k);
          for (double factor = 1.; mean - other > 1e-15 * mean; factor *= 2.)
            {
              const double half = 0.5 * (mean - other);
              const double root = std::sqrt(mean * other);
              mean -= half;
              other = root;
              sum += factor * half * half;
            }
          const double first = 0.5 * numbers::PI / mean;
          return {first, first * (1. - sum), first * sum};
        }



        /** Ratio k = b / a of the axes of the ellipse for B / A. */
        double
        axis_ratio(const double ratio)
        {
          // The logarithm of one is nearly a line in that of the other, of the
          // slope -1.5 of circles to -2 of lines.
          if (ratio < 1. + 1e-6)
            return 1.;
          constexpr double slope    = 1.6;
          constexpr double accuracy = 1e-10;
          double           k        = std::pow(ratio, -1. / slope);
          double           change   = 1.;
          for (unsigned int i = 0; i < 50 && std::abs(change) > accuracy; ++i)
            {
              const EllipticIntegrals of = integrals(k);
              change = std::log((of.second / (k * k) - of.first) /
                                (ratio * of.difference)) /
                       slope;
              k = std::min(k * std::exp(change), 1. - 1e-9);
            }
          return k;
        }
      } // namespace ElasticApproach
    }   // namespace internal



    double
    crossing_approach(const double        force,
                      const double        angle,
                      const PressedFiber &a,
                      const PressedFiber &b)
    {
      const double stiffness =
        1. / (1. / a.plane_modulus + 1. / b.plane_modulus);
      const double u = 1. / a.radius, v = 1. / b.radius;
      const double sum = 0.5 * (u + v);

      // The difference of both curvatures leaves A small at small angles: from
      // the product of both, not from B - A.
      const double difference =
        0.5 * std::sqrt(u * u + v * v + 2. * u * v * std::cos(2. * angle));
      const double larger = 0.5 * (sum + difference);
      const double smaller =
        0.25 * u * v * std::pow(std::sin(angle), 2.) / larger;
      const double k  = internal::ElasticApproach::axis_ratio(larger / smaller);
      const auto   of = internal::ElasticApproach::integrals(k);
      const double half_axis = std::cbrt(
        3. * force * of.second / (2. * numbers::PI * stiffness * k * k * sum));
      return 3. * force * of.first / (2. * numbers::PI * half_axis * stiffness);
    }



    double
    line_approach(const double        pressure,
                  const PressedFiber &a,
                  const PressedFiber &b)
    {
      if (pressure <= 0.)
        return 0.;
      const double stiffness =
        1. / (1. / a.plane_modulus + 1. / b.plane_modulus);
      const double half_width =
        std::sqrt(4. * pressure * a.radius * b.radius /
                  ((a.radius + b.radius) * numbers::PI * stiffness));
      double sum = 0.;
      for (const PressedFiber *fiber : {&a, &b})
        sum +=
          pressure / (numbers::PI * fiber->plane_modulus) *
          std::max(1., 2. * std::log(4. * fiber->radius / half_width) - 1.);
      return sum;
    }
  } // namespace Contact
} // namespace Heddle
