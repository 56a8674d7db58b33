#include <heddle/contact/intermediate_geometry.h>

#include <algorithm>
#include <cmath>

namespace Heddle
{
  namespace Contact
  {
    std::pair<double, double>
    IntermediateGeometry::range() const
    {
      if (orientation > 0)
        return {0., a.length() + b.length()};
      // Of one fiber with itself p is the separation, s_a < s_b.
      return {-b.length(), min_separation > 0. ? -min_separation : a.length()};
    }



    std::pair<double, double>
    IntermediateGeometry::range_of_q(const double p) const
    {
      // s_a = (p + q) / 2 and s_b = sigma (p - q) / 2 lie on their fibers.
      const double from_b_low  = orientation > 0 ? p - 2. * b.length() : p;
      const double from_b_high = orientation > 0 ? p : p + 2. * b.length();
      double       low         = std::max(-p, from_b_low);
      double       high        = std::min(2. * a.length() - p, from_b_high);
      if (orientation > 0 && min_separation > 0.)
        high = std::min(high, -min_separation);
      return {low, std::max(low, high)};
    }



    FacingParticles
    IntermediateGeometry::facing(const double p, double &q) const
    {
      FacingParticles             particles;
      const IntermediateGeometry *between = this;
      find_facing<1>(&between, &p, &q, &particles);
      return particles;
    }



    double
    IntermediateGeometry::kink(const FacingEnd end, const double p) const
    {
      const bool of_a =
        end == FacingEnd::first_of_a || end == FacingEnd::last_of_a;
      const bool is_first =
        end == FacingEnd::first_of_a || end == FacingEnd::first_of_b;
      const Curve     &ending = of_a ? a : b, &other = of_a ? b : a;
      const double     sigma = orientation, scale = a.radius + b.radius;
      const double     s        = is_first ? 0. : ending.length();
      unsigned int     interval = is_first ? 0 : ending.n_knots - 2;
      const CurvePoint last     = ending.evaluate(s, interval);
      unsigned int     of_other = 0;
      double           s_other  = of_a ? sigma * (p - s) : p - sigma * s;
      for (unsigned int iteration = 0; iteration < 20; ++iteration)
        {
          s_other = std::min(std::max(s_other, 0.), other.length());
          const CurvePoint   facing     = other.evaluate(s_other, of_other);
          const Tensor<1, 3> connection = last.position - facing.position;
          const Tensor<1, 3> sum        = last.tangent + sigma * facing.tangent;
          const double       stiffness =
            sigma * (connection * facing.curvature) - facing.tangent * sum;
          const double step =
            std::min(std::max(-(connection * sum) / stiffness, -scale), scale);
          s_other += step;
          if (!(std::abs(step) > 1e-11 * scale))
            break;
        }
      return of_a ? s + sigma * s_other : s_other + sigma * s;
    }
  } // namespace Contact
} // namespace Heddle
