#include <heddle/base/exceptions.h>
#include <heddle/textile/clearance.h>
#include <heddle/textile/weave.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Heddle
{
  namespace Textile
  {
    Weave::Weave(const WeaveDescription &description)
      : description(description)
      , pattern(description.pattern)
      , sections{pack_yarn(description.warp.packing, 0),
                 pack_yarn(description.weft.packing, 0)}
    {
      check(warp);
      check(weft);
      lay_out();
      if (description.start == Start::crimped)
        find_crimp();
    }



    void
    Weave::check(const Direction direction) const
    {
      const YarnFamily &yarns = family(direction);
      const std::string where =
        direction == warp ? "Weave/Warp yarns: " : "Weave/Weft yarns: ";
      if (yarns.n_yarns == 0)
        throw InputError(where + "there are none; give at least one yarn.");
      if (!(yarns.spacing >= 0.) || !std::isfinite(yarns.spacing))
        throw InputError(where + "the yarn spacing is " +
                         std::to_string(yarns.spacing) +
                         " mm; it must be positive, or 0 to be chosen.");

      const double tangent =
        2. * numbers::PI * yarns.twist * sections[direction].radius;
      const double needed = 2. * std::sqrt(1. + tangent * tangent);
      if (!(yarns.packing.spacing >= needed))
        throw InputError(where + "a twist of " + std::to_string(yarns.twist) +
                         " turns per mm presses the fibers into each other; "
                         "lower it, or raise the packing spacing from " +
                         std::to_string(yarns.packing.spacing) +
                         " to at least " + std::to_string(needed) + ".");
    }



    void
    Weave::lay_out()
    {
      if (!(description.end_length >= 0. && description.end_length <= 10.))
        throw InputError("Weave: the end length is " +
                         std::to_string(description.end_length) +
                         " spacings; it must lie between 0 and 10.");
      if (!(description.crimp_transition > 0. &&
            description.crimp_transition <= 1.))
        throw InputError("Weave: the crimp transition is " +
                         std::to_string(description.crimp_transition) +
                         "; it must be positive and at most 1.");
      if (!(description.crimp_factor >= 0. && description.crimp_factor <= 100.))
        throw InputError("Weave: the crimp factor is " +
                         std::to_string(description.crimp_factor) +
                         "; it must lie between 0 (automatic) and 100.");

      for (const Direction direction : {warp, weft})
        {
          YarnSection &section = sections[direction];
          if (family(direction).twist != 0.)
            section.width = section.height =
              2. * (section.radius + family(direction).packing.radius);
        }
      for (const Direction direction : {warp, weft})
        {
          const double asked = family(direction).spacing;
          const double automatic =
            sections[direction].width + 0.8 * sections[1 - direction].height;
          spacings[direction] = asked > 0. ? asked : automatic;
        }
      for (const Direction direction : {warp, weft})
        {
          const Direction crossed = direction == warp ? weft : warp;
          lengths[direction] =
            (family(crossed).n_yarns - 1 + 2. * description.end_length) *
            spacings[crossed];
          if (!(lengths[direction] > 0.))
            throw InputError("Weave: with one crossing per yarn and no end "
                             "length the yarns have no length; give a positive "
                             "end length.");
        }
    }



    void
    Weave::find_crimp()
    {
      const double flat =
        0.25 * (sections[warp].height + sections[weft].height);

      // Yarns that would touch as flat ribbons, then ever higher.
      const auto succeeds = [&](const bool normal, const double largest) {
        normal_sections    = normal;
        const double asked = description.crimp_factor;
        for (double factor = asked > 0. ? asked : 1.; factor <= largest;
             factor *= 1.05)
          {
            crimp_amplitude = factor * flat;
            if (is_clear())
              return true;
            if (asked > 0.)
              return false;
          }
        return false;
      };
      if (description.crimp_factor > 0.)
        {
          // Upright sections if the height asked for is too small either way.
          succeeds(true, description.crimp_factor) ||
            succeeds(false, description.crimp_factor);
          return;
        }
      if (!succeeds(true, 2.) && !succeeds(false, 6.))
        throw InputError(
          "Weave: no crimp gets the yarns clear of each other at spacings of " +
          std::to_string(spacings[warp]) + " mm (warp) and " +
          std::to_string(spacings[weft]) + " mm (weft) for yarns " +
          std::to_string(sections[warp].width) + " mm and " +
          std::to_string(sections[weft].width) +
          " mm wide; enlarge the spacing, pack the yarns hexagonally, or set a "
          "'Crimp factor' and let them overlap.");
    }



    bool
    Weave::is_clear() const
    {
      // One percent for what the polygons cut off the curves.
      const double needed = 1.01 * (description.warp.packing.radius +
                                    description.weft.packing.radius);
      return smallest_distance(
               polylines(warp), polylines(weft), 2. * needed, needed) >= needed;
    }



    double
    Weave::position(const Direction direction, const unsigned int i) const
    {
      return (i - 0.5 * (family(direction).n_yarns - 1)) * spacings[direction];
    }



    YarnAxis
    Weave::axis(const Direction direction, const unsigned int i) const
    {
      const Direction   crossed = direction == warp ? weft : warp;
      std::vector<bool> on_top;
      if (direction == warp)
        for (unsigned int j = 0; j < pattern.n_weft(); ++j)
          on_top.push_back(pattern.warp_on_top(i, j));
      else
        for (unsigned int j = 0; j < pattern.n_warp(); ++j)
          on_top.push_back(!pattern.warp_on_top(j, i));
      return YarnAxis(spacings[crossed],
                      position(crossed, 0),
                      on_top,
                      crimp_amplitude,
                      description.crimp_transition);
    }



    std::vector<Curve>
    Weave::fibers(const Direction direction, const unsigned int i) const
    {
      const YarnFamily  &yarns = family(direction);
      const unsigned int yarn =
        direction == warp ? i : description.warp.n_yarns + i;
      const YarnAxis yarn_axis = axis(direction, i);
      const double   middle    = position(direction, i);
      const double   rate      = 2. * numbers::PI * yarns.twist;

      std::vector<Curve> curves;
      for (const Point<2> &place : pack_yarn(yarns.packing, yarn).positions)
        curves.push_back([=](const double x) {
          const double cosine = std::cos(rate * x), sine = std::sin(rate * x);
          const double across = cosine * place[0] - sine * place[1];
          const double up     = sine * place[0] + cosine * place[1];
          const double slope  = normal_sections ? yarn_axis.slope(x) : 0.;
          const double length = std::sqrt(1. + slope * slope);
          const double along  = x - up * slope / length;
          const double height = yarn_axis.height(x) + up / length;
          // Along, across and up are right-handed in both directions, so that
          // warp and weft have the same sense of twist.
          return direction == warp
                   ? Tensor<1, 3>({along, middle + across, height})
                   : Tensor<1, 3>({middle - across, along, height});
        });
      return curves;
    }



    std::vector<std::vector<Tensor<1, 3>>>
    Weave::polylines(const Direction direction) const
    {
      const double       half = 0.5 * lengths[direction];
      const unsigned int n =
        std::ceil(2. * lengths[direction] / family(direction).packing.radius);

      std::vector<std::vector<Tensor<1, 3>>> lines;
      for (unsigned int i = 0; i < family(direction).n_yarns; ++i)
        for (const Curve &curve : fibers(direction, i))
          {
            lines.emplace_back();
            for (unsigned int k = 0; k <= n; ++k)
              lines.back().push_back(curve(half * (2. * k / n - 1.)));
          }
      return lines;
    }



    std::vector<FiberPath>
    Weave::paths(const unsigned int n_elements) const
    {
      std::vector<FiberPath> paths;
      for (const Direction direction : {warp, weft})
        for (unsigned int i = 0; i < family(direction).n_yarns; ++i)
          {
            const YarnFamily &yarns  = family(direction);
            const double      half   = 0.5 * lengths[direction];
            const auto        curves = fibers(direction, i);
            for (unsigned int f = 0; f < curves.size(); ++f)
              {
                const Knots knots = equally_spaced(
                  curves[f], -half, half, n_elements + 1, 64 * n_elements);
                FiberPath path;
                path.points           = knots.points;
                path.reference_length = knots.length;
                path.radius           = yarns.packing.radius;
                path.yarn_id =
                  direction == warp ? i : description.warp.n_yarns + i;
                path.bundle_id = f / yarns.packing.fibers_per_bundle;
                path.set       = direction == warp ? "warp" : "weft";
                paths.push_back(path);
              }
          }
      return paths;
    }



    std::vector<Crossing>
    Weave::crossings() const
    {
      std::vector<Crossing> crossings;
      for (unsigned int i = 0; i < description.warp.n_yarns; ++i)
        for (unsigned int j = 0; j < description.weft.n_yarns; ++j)
          crossings.push_back({i,
                               description.warp.n_yarns + j,
                               Point<2>(position(weft, j), position(warp, i)),
                               pattern.warp_on_top(i, j)});
      return crossings;
    }
  } // namespace Textile
} // namespace Heddle
