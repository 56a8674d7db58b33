#ifndef heddle_textile_interpolation_h
#define heddle_textile_interpolation_h

#include <deal.II/base/tensor.h>

#include <vector>

namespace Heddle
{
  namespace Textile
  {
    using namespace dealii;

    /** The curve that is laid through given points. */
    enum class Interpolation
    {
      /** Natural cubic spline over the chord length: C2. */
      spline,
      /** Catmull-Rom cubic over the chord length: C1, and more local. */
      catmull_rom
    };

    /** How the user names them. */
    constexpr const char *
    word(const Interpolation interpolation)
    {
      switch (interpolation)
        {
          case Interpolation::spline:
            return "spline";
          case Interpolation::catmull_rom:
            return "catmull-rom";
        }
      return nullptr;
    }



    /**
     * A piecewise cubic curve through points, parametrized by the length of
     * the chords between them.
     *
     * With the chords $h_i$, the spline's derivatives $d_i$ at the points solve
     * @f[ \frac{d_{i-1}}{h_{i-1}} + 2\left(\frac{1}{h_{i-1}} + \frac{1}{h_i}
     * \right) d_i + \frac{d_{i+1}}{h_i} = 3\left(\frac{x_i -
     * x_{i-1}}{h_{i-1}^2} + \frac{x_{i+1} - x_i}{h_i^2}\right) @f]
     * with vanishing second derivative at the ends; Catmull-Rom's are those of
     * the parabola through three neighbouring points.
     */
    class InterpolatedCurve
    {
    public:
      /** @pre At least two points, and no two consecutive ones coincide. */
      InterpolatedCurve(const std::vector<Tensor<1, 3>> &points,
                        const Interpolation              interpolation);

      /** Length of all the chords: the end of the parameter range [mm]. */
      double
      end() const
      {
        return parameters.back();
      }

      /** Position at the parameter @p t, 0 <= t <= end() [mm]. */
      Tensor<1, 3>
      operator()(const double t) const;

    private:
      void
      compute_spline_derivatives();

      void
      compute_parabola_derivatives();

      double
      chord(const unsigned int i) const
      {
        return parameters[i + 1] - parameters[i];
      }

      std::vector<Tensor<1, 3>> points;
      std::vector<double>       parameters;
      std::vector<Tensor<1, 3>> derivatives;
    };
  } // namespace Textile
} // namespace Heddle

#endif
