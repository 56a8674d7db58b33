#include <heddle/textile/yarn_axis.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Heddle
{
  namespace Textile
  {
    using namespace dealii;

    YarnAxis::YarnAxis(const double             spacing,
                       const double             first,
                       const std::vector<bool> &sides,
                       const double             amplitude,
                       const double             transition)
      : spacing(spacing)
      , first(first)
      , sides(sides)
      , amplitude(amplitude)
      , transition(transition)
    {
    }



    YarnAxis::Place
    YarnAxis::locate(const double x) const
    {
      const double crossings = (x - first) / spacing;
      const long   before    = std::floor(crossings);
      const double part      = crossings - before;

      // The pattern goes on beyond the ends of the sample, on either side.
      const long n      = sides.size();
      const auto height = [&](const long crossing) {
        return sides[((crossing % n) + n) % n] ? amplitude : -amplitude;
      };
      const double phase =
        std::clamp((part - 0.5) / transition + 0.5, 0., 1.) * numbers::PI;
      return {height(before), height(before + 1), phase};
    }



    double
    YarnAxis::height(const double x) const
    {
      const Place place = locate(x);
      return 0.5 * (place.before + place.after) +
             0.5 * (place.before - place.after) * std::cos(place.phase);
    }



    double
    YarnAxis::slope(const double x) const
    {
      const Place place = locate(x);
      return -0.5 * (place.before - place.after) * std::sin(place.phase) *
             numbers::PI / (transition * spacing);
    }
  } // namespace Textile
} // namespace Heddle
