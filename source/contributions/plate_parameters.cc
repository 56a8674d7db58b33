#include <heddle/base/exceptions.h>
#include <heddle/base/expression.h>
#include <heddle/base/number_text.h>
#include <heddle/base/turning_points.h>
#include <heddle/contributions/plate_parameters.h>

#include <cmath>

namespace Heddle
{
  namespace Contributions
  {
    const char *const PlateParameters::entry = "Plates: \"Compression\"";



    PlateParameters::PlateParameters(const std::string &section)
      : ParameterAcceptor(section)
    {
      add_parameter(
        "Compression",
        compression,
        "Formula of the load factor t, 0 at t = 0, as in '0.2*t': by which "
        "part of their distance two plates come nearer to each other. They are "
        "rigid, smooth and level, below and above all fibers, in a fabric "
        "where its yarns cross, and touch the lowest and the highest surface "
        "when a "
        "load case begins; each moves by half of it. Fibers are in them by up "
        "to Contact/Penetration threshold, which counts where less than some "
        "percent are pressed. Where the formula turns back there is a load "
        "step. '0': there are no plates [-].");
      parse_parameters_call_back.connect([this]() { check(); });
    }



    void
    PlateParameters::check() const
    {
      if (!are_there())
        return;
      const Expression  formula(compression, entry);
      const std::string is =
        entry + std::string(" is \"") + compression + "\", ";
      const auto at = [&formula](const double t) {
        return formula.value(Tensor<1, 3>(), t);
      };
      require(std::abs(at(0.)) < 1e-12,
              is + "which is " + number_text(at(0.)) +
                " at t = 0; let it begin at 0.");
      std::vector<double> load_factors = turning_points();
      for (unsigned int i = 1; i <= 100; ++i)
        load_factors.push_back(0.01 * i);
      for (const double t : load_factors)
        {
          require(at(t) == formula.value(Tensor<1, 3>({0.1, 0.2, 0.3}), t),
                  is + "which is not the same everywhere; let it depend on t "
                       "alone.");
          require(at(t) < 1.,
                  is + "which is " + number_text(at(t)) +
                    " at t = " + number_text(t) +
                    ", where plates would have met; it must stay below 1, and "
                    "0.2 are 20 %.");
        }
    }



    std::vector<double>
    PlateParameters::turning_points() const
    {
      return Heddle::turning_points(Expression(compression, entry));
    }
  } // namespace Contributions
} // namespace Heddle
