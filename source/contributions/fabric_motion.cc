#include <heddle/contributions/fabric_motion.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace Heddle
{
  namespace Contributions
  {
    FabricMotion::FabricMotion(const Both<double> &strains,
                               const double        shear_angle,
                               const Shear         shear,
                               const std::string  &ramp)
      : strains(strains)
      , angle(shear_angle)
      , shear(shear)
      , ramp_text(ramp)
      , ramp(ramp, "Fabric loading: \"Ramp\"")
    {
    }



    std::string
    FabricMotion::times_ramp(const double value) const
    {
      std::ostringstream text;
      text << '(' << std::setprecision(17) << value << ")*(" << ramp_text
           << ')';
      return text.str();
    }



    FabricMotion::Both<std::string>
    FabricMotion::displacements() const
    {
      const std::string x = "x*(1+" + times_ramp(strains[0]) + ")";
      const std::string y = "y*(1+" + times_ramp(strains[1]) + ")";
      if (angle == 0.)
        return {{times_ramp(strains[0]) + "*x", times_ramp(strains[1]) + "*y"}};
      if (shear == Shear::simple)
        return {{x + "-x+" + y + "*tan(" + times_ramp(angle) + ")", y + "-y"}};
      const std::string cosine = "*cos(" + times_ramp(0.5 * angle) + ")",
                        sine   = "*sin(" + times_ramp(0.5 * angle) + ")";
      return {
        {x + cosine + "-x+" + y + sine, x + sine + "+" + y + cosine + "-y"}};
    }



    FabricMotion::Both<std::string>
    FabricMotion::turn_angles() const
    {
      const Both<double> rates = turn_rates();
      return {{times_ramp(rates[0] * angle), times_ramp(rates[1] * angle)}};
    }



    double
    FabricMotion::shear_angle(const double load_factor) const
    {
      return angle * ramp.value(Tensor<1, 3>(), load_factor);
    }



    double
    FabricMotion::strain(const unsigned int direction,
                         const double       load_factor) const
    {
      return strains[direction] * ramp.value(Tensor<1, 3>(), load_factor);
    }



    FabricMotion::Both<Tensor<1, 3>>
    FabricMotion::directions(const double load_factor) const
    {
      const double gamma = shear_angle(load_factor);
      if (shear == Shear::simple)
        return {{Tensor<1, 3>({1., 0., 0.}),
                 Tensor<1, 3>({std::tan(gamma), 1., 0.})}};
      const double cosine = std::cos(0.5 * gamma), sine = std::sin(0.5 * gamma);
      return {
        {Tensor<1, 3>({cosine, sine, 0.}), Tensor<1, 3>({sine, cosine, 0.})}};
    }



    FabricMotion::Both<Tensor<1, 3>>
    FabricMotion::turning(const double load_factor) const
    {
      const double gamma = shear_angle(load_factor);
      if (shear == Shear::simple)
        return {{Tensor<1, 3>(),
                 Tensor<1, 3>({1. + std::pow(std::tan(gamma), 2), 0., 0.})}};
      const double cosine = 0.5 * std::cos(0.5 * gamma),
                   sine   = 0.5 * std::sin(0.5 * gamma);
      return {
        {Tensor<1, 3>({-sine, cosine, 0.}), Tensor<1, 3>({cosine, -sine, 0.})}};
    }



    FabricMotion::Both<double>
    FabricMotion::turn_rates() const
    {
      if (shear == Shear::simple)
        return {{0., -1.}};
      return {{0.5, -0.5}};
    }
  } // namespace Contributions
} // namespace Heddle
