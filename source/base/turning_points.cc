#include <heddle/base/turning_points.h>

#include <cmath>

namespace Heddle
{
  namespace
  {
    /** The load factor that was meant, if it is a round one. */
    double
    rounded(const double found)
    {
      const double round = std::round(1e6 * found) / 1e6;
      return std::abs(found - round) < 1e-8 ? round : found;
    }
  } // namespace



  std::vector<double>
  turning_points(const Expression &formula)
  {
    const auto at = [&formula](const double t) {
      return formula.value(Tensor<1, 3>(), t);
    };

    // Sampled finely, then drawn together by golden section, which needs no
    // derivative: most have a kink there.
    constexpr unsigned int n      = 1000;
    const double           golden = 0.5 * (std::sqrt(5.) - 1.);
    std::vector<double>    points;

    // The last slope that was not 0, where it ended, and how many there were.
    double       slope = 0., slope_end = 0.;
    unsigned int n_before = 0;
    for (unsigned int i = 1; i < n; ++i)
      {
        double       low = (i - 1.) / n, high = (i + 1.) / n;
        const double here   = double(i) / n;
        const double before = at(here) - at(low), after = at(high) - at(here);
        if (before != 0.)
          {
            slope     = before;
            slope_end = here;
            n_before  = points.size();
          }
        else if (slope * after < 0. && points.size() == n_before)
          {
            // It has stayed for a while: a step goes to where this began.
            const double stay = at(slope_end);
            low               = slope_end - 1. / n;
            high              = slope_end;
            while (high - low > 1e-9)
              {
                const double middle               = 0.5 * (low + high);
                (at(middle) == stay ? high : low) = middle;
              }
            points.push_back(rounded(high));
          }
        if (before == 0. || before * after > 0.)
          continue;
        const double sign = before > 0. ? 1. : -1., beyond = sign * at(high);
        while (high - low > 1e-9)
          {
            const double left  = high - golden * (high - low),
                         right = low + golden * (high - low);
            (sign * at(left) > sign * at(right) ? high : low) =
              sign * at(left) > sign * at(right) ? right : left;
          }
        const double point = rounded(0.5 * (low + high));
        if (sign * at(point) > beyond)
          points.push_back(point);
      }
    return points;
  }
} // namespace Heddle
