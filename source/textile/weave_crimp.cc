#include <heddle/base/exceptions.h>
#include <heddle/base/number_text.h>
#include <heddle/textile/clearance.h>
#include <heddle/textile/weave.h>

#include <array>
#include <cmath>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      /** What fibers advance at least, over what the axis of their yarn does.
       */
      constexpr double least_advance = 0.3;
    } // namespace



    void
    Weave::find_crimp()
    {
      const double asked = description.crimp_factor;
      if (asked > 0.)
        {
          // Upright sections leave more room if the height does not suffice.
          if (!raise_until(&Weave::is_clear, /*normal=*/true, asked, asked))
            raise_until(&Weave::is_clear, /*normal=*/false, asked, asked);
          return;
        }
      // Crimp that is high enough to be clear of a wide yarn close by takes
      // long to settle: then it does if the fibers lie in the right order.
      if (!raise_until(&Weave::is_clear, /*normal=*/true, 1., 1.5) &&
          !raise_until(&Weave::is_clear, /*normal=*/false, 1., 1.5) &&
          !raise_until(&Weave::is_in_order, /*normal=*/false, 1., 6.))
        throw InputError(
          "Weave: no crimp gets the yarns past each other at spacings of " +
          number_text(spacings[warp], 4) + " mm (warp) and " +
          number_text(spacings[weft], 4) + " mm (weft) for yarns " +
          number_text(sections[warp].width, 4) + " mm and " +
          number_text(sections[weft].width, 4) +
          " mm wide; enlarge Weave/Warp yarns/Yarn spacing" +
          (description.warp.packing.layout == Layout::hexagonal &&
               description.weft.packing.layout == Layout::hexagonal
             ? ""
             : ", set Weave/Warp yarns/Packing = hexagonal") +
          ", or Weave/Crimp factor to start from yarns that lie in each "
          "other.");
    }



    bool
    Weave::raise_until(bool (Weave::*goal)() const,
                       const bool   normal,
                       const double smallest,
                       const double largest)
    {
      normal_sections = normal;
      for (double factor = smallest; factor <= largest; factor *= 1.05)
        {
          crimp_amplitude =
            factor * 0.25 * (sections[warp].height + sections[weft].height);
          if ((this->*goal)())
            return true;
        }
      return false;
    }



    bool
    Weave::is_clear() const
    {
      // One percent for what the polygons cut off the curves.
      const double needed = 1.01 * (description.warp.packing.radius +
                                    description.weft.packing.radius);
      const std::array<std::vector<Polyline>, 2> lines = {
        {polylines(warp), polylines(weft)}};
      for (const Direction direction : {warp, weft})
        for (const Polyline &line : lines[direction])
          {
            // Inside of a bend that is sharper than the yarn is thick fibers
            // would run back.
            const double step = lengths[direction] / (line.size() - 1);
            for (unsigned int k = 0; k + 1 < line.size(); ++k)
              if (line[k + 1][direction] - line[k][direction] <
                  least_advance * step)
                return false;
          }
      return smallest_distance(lines[warp], lines[weft], 2. * needed, needed) >=
             needed;
    }



    bool
    Weave::is_in_order() const
    {
      const double needed = 0.5 * (description.warp.packing.radius +
                                   description.weft.packing.radius);

      std::vector<std::vector<ParametricCurve>> weft_yarns;
      for (unsigned int j = 0; j < description.weft.n_yarns; ++j)
        weft_yarns.push_back(fibers(weft, j));
      for (unsigned int i = 0; i < description.warp.n_yarns; ++i)
        for (const ParametricCurve &warp_fiber : fibers(warp, i))
          for (unsigned int j = 0; j < weft_yarns.size(); ++j)
            for (const ParametricCurve &weft_fiber : weft_yarns[j])
              {
                // Upright fibers run straight in the plane, but for the twist.
                const double x    = weft_fiber(position(warp, i))[0];
                const double y    = warp_fiber(position(weft, j))[1];
                const double rise = warp_fiber(x)[2] - weft_fiber(y)[2];
                if ((pattern.warp_on_top(i, j) ? rise : -rise) < needed)
                  return false;
              }
      return true;
    }



    std::vector<Polyline>
    Weave::polylines(const Direction direction) const
    {
      const double       half = 0.5 * lengths[direction];
      const unsigned int n =
        std::ceil(2. * lengths[direction] / family(direction).packing.radius);

      std::vector<Polyline> lines;
      for (unsigned int i = 0; i < family(direction).n_yarns; ++i)
        for (const ParametricCurve &curve : fibers(direction, i))
          {
            lines.emplace_back();
            for (unsigned int k = 0; k <= n; ++k)
              lines.back().push_back(curve(half * (2. * k / n - 1.)));
          }
      return lines;
    }
  } // namespace Textile
} // namespace Heddle
