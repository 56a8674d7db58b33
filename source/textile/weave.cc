#include <heddle/base/exceptions.h>
#include <heddle/base/yarn_set.h>
#include <heddle/textile/weave.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <sstream>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      const WeaveDescription &
      checked(const WeaveDescription &description)
      {
        check_weave(description);
        return description;
      }
    } // namespace



    Weave::Weave(const WeaveDescription &description)
      : description(checked(description))
      , pattern(description.pattern)
      , sections{pack_yarn(description.warp.packing, 0),
                 pack_yarn(description.weft.packing, 0)}
    {
      lay_out();
      if (description.start == Start::crimped)
        find_crimp();
    }



    void
    Weave::check_size(const Direction direction) const
    {
      // Of a fabric, not of numbers that were typed in another unit.
      constexpr double most     = 1e8;
      const Packing   &packing  = family(direction).packing;
      const double     n_fibers = double(family(direction).n_yarns) *
                              packing.n_bundles * packing.fibers_per_bundle;
      const double n_radii = lengths[direction] / packing.radius;
      if (!(n_fibers * n_radii <= most))
        {
          std::ostringstream text;
          text << "Weave: " << n_fibers << " fibers of " << lengths[direction]
               << " mm and radius " << packing.radius
               << " mm are more than this program can lay out, " << most
               << " radii in all; are numbers and units as they were meant?";
          throw InputError(text.str());
        }
    }



    void
    Weave::lay_out()
    {
      for (const Direction direction : {warp, weft})
        {
          // Twist turns a flat section through the thickness.
          PackedSection &section = sections[direction];
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
          const Direction crossed = other(direction);
          lengths[direction] =
            (family(crossed).n_yarns - 1 + 2. * description.end_length) *
            spacings[crossed];
          if (!(lengths[direction] > 0.))
            throw InputError("Weave: with one crossing per yarn and no end "
                             "length the yarns have no length; give a positive "
                             "end length.");
          check_size(direction);
        }
    }



    double
    Weave::position(const Direction direction, const unsigned int i) const
    {
      return (i - 0.5 * (family(direction).n_yarns - 1)) * spacings[direction];
    }



    YarnAxis
    Weave::axis(const Direction direction, const unsigned int i) const
    {
      const Direction   crossed = other(direction);
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



    std::vector<ParametricCurve>
    Weave::fibers(const Direction direction, const unsigned int i) const
    {
      const YarnFamily  &yarns = family(direction);
      const unsigned int yarn =
        direction == warp ? i : description.warp.n_yarns + i;
      const YarnAxis yarn_axis = axis(direction, i);
      const double   middle    = position(direction, i);
      const double   rate      = 2. * numbers::PI * yarns.twist;
      const bool     normal    = normal_sections;

      std::vector<ParametricCurve> curves;
      for (const Point<2> &place : pack_yarn(yarns.packing, yarn).positions)
        curves.push_back([=](const double x) {
          const double cosine = std::cos(rate * x), sine = std::sin(rate * x);
          const double across = cosine * place[0] - sine * place[1];
          const double up     = sine * place[0] + cosine * place[1];
          const double slope  = normal ? yarn_axis.slope(x) : 0.;
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



    std::vector<std::pair<Weave::Direction, unsigned int>>
    Weave::yarns_in_turn() const
    {
      // By their places: the i-th of n at (i + 1/2) / n, without division.
      const unsigned int n_warp = description.warp.n_yarns,
                         n_weft = description.weft.n_yarns;
      std::vector<std::pair<Direction, unsigned int>> yarns;
      unsigned int                                    i = 0, j = 0;
      while (i < n_warp || j < n_weft)
        if (j == n_weft ||
            (i < n_warp && (2 * i + 1) * n_weft <= (2 * j + 1) * n_warp))
          yarns.emplace_back(warp, i++);
        else
          yarns.emplace_back(weft, j++);
      return yarns;
    }



    std::vector<FiberPath>
    Weave::paths(const unsigned int n_elements) const
    {
      std::vector<FiberPath> paths;
      for (const auto &[direction, i] : yarns_in_turn())
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
              path.filament_radius  = yarns.packing.filament_radius;
              path.density          = yarns.density;
              path.yarn_id =
                direction == warp ? i : description.warp.n_yarns + i;
              path.bundle_id = f / yarns.packing.fibers_per_bundle;
              path.set       = word(YarnSet(direction));
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
