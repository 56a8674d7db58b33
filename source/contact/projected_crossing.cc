#include <heddle/contact/projected_crossing.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Heddle
{
  namespace Contact
  {
    namespace
    {
      /** Sine of the angle below which two projections do not cross. */
      constexpr double least_sine = 0.1;

      /** Distance of the projections, over the radius, that counts as none. */
      constexpr double tolerance = 1e-10;

      /** What places are off, over themselves: some last digits. */
      constexpr double last_digits =
        8. * std::numeric_limits<double>::epsilon();



      double
      cross(const Tensor<1, 3> &u, const Tensor<1, 3> &v)
      {
        return u[0] * v[1] - u[1] * v[0];
      }



      void
      start_from_knots(const Curve &a, const Curve &b, ProjectedCrossing &start)
      {
        double closest = std::numeric_limits<double>::max();
        for (unsigned int i = a.known.first; i < a.known.second; ++i)
          for (unsigned int j = b.known.first; j < b.known.second; ++j)
            {
              const double x        = a.position(i)[0] - b.position(j)[0];
              const double y        = a.position(i)[1] - b.position(j)[1];
              const double distance = x * x + y * y;
              if (distance < closest)
                {
                  closest   = distance;
                  start.s_a = a.arc_lengths[i];
                  start.s_b = b.arc_lengths[j];
                }
            }
      }



      /** The nearest arc length at which the curve is known. */
      double
      bounded(const double s, const Curve &curve)
      {
        return std::min(std::max(s, curve.arc_lengths[curve.known.first]),
                        curve.arc_lengths[curve.known.second - 1]);
      }



      /** Newton's method on the distance of the projections. */
      bool
      improve(const Curve &a, const Curve &b, ProjectedCrossing &crossing)
      {
        unsigned int interval_a = crossing.s_a / a.length() * (a.n_knots - 1);
        unsigned int interval_b = crossing.s_b / b.length() * (b.n_knots - 1);
        for (unsigned int iteration = 0; iteration < 20; ++iteration)
          {
            const CurvePoint   on_a  = a.evaluate(crossing.s_a, interval_a);
            const CurvePoint   on_b  = b.evaluate(crossing.s_b, interval_b);
            const Tensor<1, 3> apart = on_a.position - on_b.position;
            const double       sine  = cross(on_a.tangent, on_b.tangent);
            if (std::abs(sine) < least_sine)
              return false;
            if (std::hypot(apart[0], apart[1]) <
                std::max(tolerance * a.radius,
                         last_digits * on_a.position.norm()))
              {
                crossing.height = apart[2];
                crossing.normal =
                  cross_product_3d(on_a.tangent, on_b.tangent) / sine;
                return true;
              }
            const double s_a = crossing.s_a - cross(apart, on_b.tangent) / sine;
            const double s_b = crossing.s_b - cross(apart, on_a.tangent) / sine;
            crossing.s_a     = bounded(s_a, a);
            crossing.s_b     = bounded(s_b, b);
          }
        return false;
      }
    } // namespace



    bool
    find_projected_crossing(const Curve       &a,
                            const Curve       &b,
                            ProjectedCrossing &crossing)
    {
      if (crossing.s_a >= 0. && improve(a, b, crossing))
        return true;
      start_from_knots(a, b, crossing);
      if (improve(a, b, crossing))
        return true;
      crossing.s_a = crossing.s_b = -1.;
      return false;
    }
  } // namespace Contact
} // namespace Heddle
