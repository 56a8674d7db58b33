#include <heddle/contact/intermediate_geometry.h>

#include <algorithm>
#include <cmath>

namespace Heddle
{
  namespace Contact
  {
    namespace
    {
      /**
       * So short a step of Newton's method, in radii, is the last one: what it
       * leaves is of second order ...
       */
      constexpr double last_step = 1e-6;

      /** ... but not where the stiffness is none of the distance. */
      constexpr double last_step_downhill = 1e-9;
    } // namespace



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
      const auto      bounds = range_of_q(p);
      const double    sigma  = orientation;
      const double    scale  = a.radius + b.radius;
      FacingParticles result;

      q                 = std::min(std::max(q, bounds.first), bounds.second);
      result.interval_a = a.interval(0.5 * (p + q));
      result.interval_b = b.interval(0.5 * sigma * (p - q));

      PaddedPoint point_a, point_b;
      double      connection[4];
      for (unsigned int iteration = 0; iteration < 30; ++iteration)
        {
          point_a = a.evaluate_padded(0.5 * (p + q), result.interval_a);
          point_b = b.evaluate_padded(0.5 * sigma * (p - q), result.interval_b);

          // Newton's method for the stationary distance; where the distance is
          // not convex, downhill with the stiffness of straight fibers.
          double sum[4], bent[4], force = 0., convex = 0., curved = 0.;
          for (unsigned int k = 0; k < 4; ++k)
            {
              connection[k] = point_a.position[k] - point_b.position[k];
              sum[k]        = point_a.tangent[k] + sigma * point_b.tangent[k];
              bent[k]       = point_a.curvature[k] - point_b.curvature[k];
              force += connection[k] * sum[k];
              convex += 0.5 * sum[k] * sum[k];
              curved += 0.5 * connection[k] * bent[k];
            }
          const double least     = 0.2 * convex + 1e-3;
          const double stiffness = std::max(convex + curved, least);
          double step = std::min(std::max(-force / stiffness, -scale), scale);
          step = std::min(std::max(q + step, bounds.first), bounds.second) - q;
          q += step;
          if (std::abs(step) <
              (stiffness > least ? last_step : last_step_downhill) * scale)
            {
              // What is left of third order is below round-off.
              const double half = 0.5 * step;
              for (unsigned int k = 0; k < 4; ++k)
                {
                  connection[k] += half * sum[k] + 0.5 * half * half * bent[k];
                  point_a.tangent[k] += half * point_a.curvature[k];
                  point_b.tangent[k] -= half * sigma * point_b.curvature[k];
                }
              break;
            }
        }
      for (unsigned int d = 0; d < 3; ++d)
        result.connection[d] = connection[d];

      result.s_a              = 0.5 * (p + q);
      result.s_b              = 0.5 * sigma * (p - q);
      result.squared_distance = result.connection.norm_square();

      // Along p both particles advance by half, but at the end of a fiber only
      // the other one does.
      const double tolerance = 1e-9 * scale;
      result.end             = result.s_a < tolerance ? FacingEnd::first_of_a
                               : result.s_a > a.length() - tolerance ? FacingEnd::last_of_a
                               : result.s_b < tolerance ? FacingEnd::first_of_b
                               : result.s_b > b.length() - tolerance ? FacingEnd::last_of_b
                                                                     : FacingEnd::none;
      double advance_a = 0.5, advance_b = 0.5 * sigma;
      if (result.end == FacingEnd::first_of_a ||
          result.end == FacingEnd::last_of_a)
        advance_a = 0., advance_b = sigma;
      else if (result.end != FacingEnd::none)
        advance_a = 1., advance_b = 0.;
      result.slope = 0.;
      for (unsigned int k = 0; k < 3; ++k)
        result.slope +=
          2. * connection[k] *
          (advance_a * point_a.tangent[k] - advance_b * point_b.tangent[k]);

      // A fiber does not touch its own neighbourhood.
      if (min_separation > 0. && orientation > 0 &&
          q > bounds.second - tolerance)
        result.squared_distance = 1e6 * scale * scale;
      return result;
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
