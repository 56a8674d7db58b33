#ifndef heddle_textile_parametric_curve_h
#define heddle_textile_parametric_curve_h

#include <deal.II/base/tensor.h>

#include <functional>
#include <vector>

namespace Heddle
{
  namespace Textile
  {
    using namespace dealii;

    /** A curve in space by any parameter, positions in mm. */
    using ParametricCurve = std::function<Tensor<1, 3>(const double)>;



    /** Knots on a curve and the length of the curve itself. */
    struct Knots
    {
      /** Equally spaced in arc length, both ends included [mm]. */
      std::vector<Tensor<1, 3>> points;

      /** Arc length of the curve, not of the polygon [mm]. */
      double length = 0.;
    };



    /**
     * Put @p n_points >= 2 knots on the piece [begin, end] of @p curve. Arc
     * length is measured on a polygon of @p n_samples equal parameter steps,
     * with an error of second order in their size.
     */
    Knots
    equally_spaced(const ParametricCurve &curve,
                   const double           begin,
                   const double           end,
                   const unsigned int     n_points,
                   const unsigned int     n_samples);
  } // namespace Textile
} // namespace Heddle

#endif
