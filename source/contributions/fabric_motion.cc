#include <heddle/contributions/fabric_motion.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace Heddle
{
  namespace Contributions
  {
    namespace
    {
      const std::string fabric_ramp = "Fabric loading: \"Ramp\"";



      /** "(0.02)*(t)": a number times the ramp. */
      std::string
      times_ramp(const double value, const std::string &ramp)
      {
        std::ostringstream text;
        text << '(' << std::setprecision(17) << value << ")*(" << ramp << ')';
        return text.str();
      }



      /** Formulas of t: the components along x and y of both directions. */
      FabricMotion::Both<FabricMotion::Both<std::string>>
      direction_formulas(const FabricMotion::Shear shear,
                         const double              angle,
                         const std::string        &ramp)
      {
        if (angle == 0.)
          return {{{{"1", "0"}}, {{"0", "1"}}}};
        switch (shear)
          {
            case FabricMotion::Shear::picture_frame:
              {
                const std::string half =
                  "(" + times_ramp(0.5 * angle, ramp) + ")";
                const std::string cosine = "cos" + half, sine = "sin" + half;
                return {{{{cosine, sine}}, {{sine, cosine}}}};
              }
            case FabricMotion::Shear::simple:
              return {{{{"1", "0"}},
                       {{"tan(" + times_ramp(angle, ramp) + ")", "1"}}}};
          }
        Assert(false, ExcInternalError());
        return {};
      }
    } // namespace



    FabricMotion::FabricMotion(const Both<double> &strains,
                               const double        shear_angle,
                               const Shear         shear,
                               const std::string  &ramp)
      : strains(strains)
      , angle(shear_angle)
      , shear(shear)
      , ramp_text(ramp)
      , ramp(ramp, fabric_ramp)
      , formulas(direction_formulas(shear, shear_angle, ramp))
    {
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int d = 0; d < 2; ++d)
          components[i].emplace_back(formulas[i][d], fabric_ramp);
    }



    FabricMotion::Both<std::string>
    FabricMotion::displacements() const
    {
      const auto stretched = [&](const unsigned int i) {
        return std::string(1, "xy"[i]) + "*(1+" +
               times_ramp(strains[i], ramp_text) + ")";
      };
      Both<std::string> result;
      for (unsigned int d = 0; d < 2; ++d)
        if (angle == 0.)
          // Nothing is subtracted from what it is nearly equal to.
          result[d] = times_ramp(strains[d], ramp_text) + "*" + "xy"[d];
        else
          for (unsigned int i = 0; i < 2; ++i)
            {
              if (formulas[i][d] == "0")
                continue;
              result[d] += (result[d].empty() ? "" : "+") + stretched(i);
              if (formulas[i][d] != "1")
                result[d] += "*" + formulas[i][d];
              if (i == d)
                result[d] += std::string("-") + "xy"[d];
            }
      return result;
    }



    FabricMotion::Both<std::string>
    FabricMotion::turn_angles() const
    {
      const Both<double> rates = turn_rates();
      return {{times_ramp(rates[0] * angle, ramp_text),
               times_ramp(rates[1] * angle, ramp_text)}};
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
      Both<Tensor<1, 3>> result;
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int d = 0; d < 2; ++d)
          result[i][d] = components[i][d].value(Tensor<1, 3>(), load_factor);
      return result;
    }



    FabricMotion::Both<Tensor<1, 3>>
    FabricMotion::turning(const double load_factor) const
    {
      const Both<Tensor<1, 3>> along = directions(load_factor);
      const Both<double>       rates = turn_rates();
      Both<Tensor<1, 3>>       result;
      switch (shear)
        {
          case Shear::picture_frame:
            // They only turn.
            for (unsigned int i = 0; i < 2; ++i)
              result[i] = Tensor<1, 3>(
                {-rates[i] * along[i][1], rates[i] * along[i][0], 0.});
            break;
          case Shear::simple:
            // The weft is (tan gamma, 1).
            result[1][0] = 1. + std::pow(along[1][0], 2);
            break;
        }
      return result;
    }



    FabricMotion::Both<double>
    FabricMotion::turn_rates() const
    {
      switch (shear)
        {
          case Shear::picture_frame:
            return {{0.5, -0.5}};
          case Shear::simple:
            return {{0., -1.}};
        }
      Assert(false, ExcInternalError());
      return {};
    }
  } // namespace Contributions
} // namespace Heddle
