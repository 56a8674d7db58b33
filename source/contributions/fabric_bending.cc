#include <heddle/base/number_text.h>
#include <heddle/contributions/fabric_bending.h>

#include <cmath>

namespace Heddle
{
  namespace Contributions
  {
    namespace
    {
      constexpr unsigned int upwards = 2;

      /** Angles below this are small: series are exact to the last digits. */
      constexpr double small_angle = 1e-2;
    } // namespace



    FabricBending::FabricBending(const unsigned int direction,
                                 const double       curvature,
                                 const std::string &ramp)
      : along(direction)
      , curvature_text("(" + number_text(curvature, 17) + ")*(" + ramp + ")")
      , curvature_formula(curvature_text, "Fabric loading: \"Ramp\"")
    {
    }



    std::array<std::string, 3>
    FabricBending::displacement() const
    {
      const std::string          k     = "(" + curvature_text + ")";
      const std::string          angle = k + "*" + "xy"[along];
      const std::string          rise = "2*sin(0.5*" + angle + ")^2"; // 1 - cos
      std::array<std::string, 3> result = {{"0", "0", "0"}};
      result[along] = "if(" + k + "==0,0,sin(" + angle + ")/" + k + "-" +
                      "xy"[along] + ")-z*sin(" + angle + ")";
      result[upwards] = "if(" + k + "==0,0," + rise + "/" + k + ")-z*" + rise;
      return result;
    }



    std::string
    FabricBending::turn_angle() const
    {
      return curvature_text + "*" + "xy"[along];
    }



    Tensor<1, 3>
    FabricBending::axis() const
    {
      return along == 0 ? Tensor<1, 3>({0., -1., 0.})
                        : Tensor<1, 3>({1., 0., 0.});
    }



    double
    FabricBending::curvature(const double load_factor) const
    {
      return curvature_formula.value(Tensor<1, 3>(), load_factor);
    }



    Tensor<1, 3>
    FabricBending::displacement(const Tensor<1, 3> &position,
                                const double        load_factor) const
    {
      const double k = curvature(load_factor), x = position[along],
                   z     = position[upwards];
      const double angle = k * x,
                   rise  = 2. * std::pow(std::sin(0.5 * angle), 2);
      Tensor<1, 3> result;
      result[along] =
        (k == 0. ? 0. : std::sin(angle) / k - x) - z * std::sin(angle);
      result[upwards] = (k == 0. ? 0. : rise / k) - z * rise;
      return result;
    }



    Tensor<1, 3>
    FabricBending::flattened(const Tensor<1, 3> &place,
                             const double        load_factor) const
    {
      const double k = curvature(load_factor), x = place[along],
                   z      = place[upwards];
      Tensor<1, 3> result = place;
      result[along]       = k == 0. ? x : std::atan2(k * x, 1. - k * z) / k;
      result[upwards] =
        (2. * z - k * (x * x + z * z)) / (1. + std::hypot(k * x, 1. - k * z));
      return result;
    }



    Tensor<1, 3>
    FabricBending::displacement_rate(const Tensor<1, 3> &position,
                                     const double        load_factor) const
    {
      const double x = position[along], z = position[upwards];
      const double a = curvature(load_factor) * x;
      // (a cos a - sin a) / a^2 and (a sin a - 1 + cos a) / a^2
      const bool   small = std::abs(a) < small_angle;
      const double shortening =
        small ? a * (-1. / 3. + a * a * (1. / 30. - a * a / 840.))
              : (a * std::cos(a) - std::sin(a)) / (a * a);
      const double lift = small
                            ? 0.5 - a * a * (1. / 8. - a * a / 144.)
                            : (a * std::sin(a) - 1. + std::cos(a)) / (a * a);
      Tensor<1, 3> result;
      result[along]   = x * x * shortening - z * x * std::cos(a);
      result[upwards] = x * x * lift - z * x * std::sin(a);
      return result;
    }



    Tensor<1, 3>
    FabricBending::tangent(const Tensor<1, 3> &position,
                           const double        load_factor) const
    {
      const double angle = curvature(load_factor) * position[along];
      Tensor<1, 3> result;
      result[along]   = std::cos(angle);
      result[upwards] = std::sin(angle);
      return result;
    }
  } // namespace Contributions
} // namespace Heddle
