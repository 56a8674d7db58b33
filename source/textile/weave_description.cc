#include <heddle/base/exceptions.h>
#include <heddle/base/number_text.h>
#include <heddle/textile/weave_description.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      /**
       * The distance of fibers, in radii, from which on they are clear of each
       * other in a yarn as it is packed: sections normal to inclined fibers
       * come closer than those that the packing sees, which are normal to the
       * yarn.
       */
      double
      least_spacing(const YarnFamily &yarns)
      {
        const double tangent =
          2. * numbers::PI * yarns.twist * pack_yarn(yarns.packing, 0).radius;
        return 2. * std::sqrt(1. + tangent * tangent);
      }



      /**
       * The spacing that is enough for a yarn which is as thick as that makes
       * it, rounded up to a thousandth: fibers are inclined the more the
       * further out they are. Infinite if there is none.
       */
      double
      enough_spacing(YarnFamily yarns)
      {
        constexpr double widest = 10.; // further apart they are no yarn
        constexpr double digits = 1000.;
        while (yarns.packing.spacing <= widest)
          {
            const double needed =
              std::ceil(digits * least_spacing(yarns)) / digits;
            if (yarns.packing.spacing >= needed)
              return yarns.packing.spacing;
            yarns.packing.spacing = needed;
          }
        return std::numeric_limits<double>::infinity();
      }



      void
      check_family(const YarnFamily &yarns, const std::string &where)
      {
        if (yarns.n_yarns == 0)
          throw InputError(where + ": there are none; give at least one yarn.");
        if (!(yarns.spacing >= 0.) || !std::isfinite(yarns.spacing))
          throw InputError(where + ": the yarn spacing is " +
                           number_text(yarns.spacing) +
                           " mm; it must be positive, or 0 to be chosen.");
        check_packing(yarns.packing, where);

        const double needed = least_spacing(yarns);
        if (!(yarns.packing.spacing >= needed))
          {
            const double enough = enough_spacing(yarns);
            throw InputError(
              where + ": a twist of " + number_text(yarns.twist) +
              " turns per mm presses the fibers into each other; lower it" +
              (std::isfinite(enough) ? ", or raise the packing spacing from " +
                                         number_text(yarns.packing.spacing) +
                                         " to at least " + number_text(enough)
                                     : ": no packing spacing is enough") +
              ".");
          }
      }
    } // namespace



    void
    check_weave(const WeaveDescription &description)
    {
      constexpr double most_fibers = 1e7;
      double           n_fibers    = 0.;
      for (const YarnFamily *family : {&description.warp, &description.weft})
        n_fibers += double(family->n_yarns) * family->packing.n_bundles *
                    family->packing.fibers_per_bundle;
      if (!(n_fibers <= most_fibers))
        throw InputError(
          "Weave: the yarns have " +
          std::to_string(static_cast<std::uint64_t>(n_fibers)) +
          " fibers; at most " +
          std::to_string(static_cast<std::uint64_t>(most_fibers)) +
          " are possible.");
      check_family(description.warp, "Weave/Warp yarns");
      check_family(description.weft, "Weave/Weft yarns");

      const auto refuse = [](const std::string &what,
                             const double       value,
                             const std::string &allowed) {
        throw InputError("Weave: the " + what + " is " + number_text(value) +
                         "; it must " + allowed + ".");
      };
      // A number compares false with everything if it is not one.
      const double end = description.end_length;
      if (!(end >= 0. && end <= 10.))
        refuse("end length", end, "lie between 0 and 10 spacings");
      const double transition = description.crimp_transition;
      if (!(transition > 0. && transition <= 1.))
        refuse("crimp transition", transition, "be positive and at most 1");
      const double factor = description.crimp_factor;
      if (!(factor >= 0. && factor <= 100.))
        refuse("crimp factor", factor, "lie between 0 (automatic) and 100");
    }
  } // namespace Textile
} // namespace Heddle
