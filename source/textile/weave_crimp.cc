#include <heddle/base/exceptions.h>
#include <heddle/textile/clearance.h>
#include <heddle/textile/weave.h>

#include <cmath>

namespace Heddle
{
  namespace Textile
  {
    void
    Weave::find_crimp()
    {
      const double asked = description.crimp_factor;
      if (asked > 0.)
        {
          // Upright sections leave more room if the height does not suffice.
          if (!raise_until_clear(/*normal=*/true, asked, asked))
            raise_until_clear(/*normal=*/false, asked, asked);
          return;
        }
      if (!raise_until_clear(/*normal=*/true, 1., 2.) &&
          !raise_until_clear(/*normal=*/false, 1., 6.))
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
    Weave::raise_until_clear(const bool   normal,
                             const double smallest,
                             const double largest)
    {
      normal_sections = normal;
      for (double factor = smallest; factor <= largest; factor *= 1.05)
        {
          crimp_amplitude =
            factor * 0.25 * (sections[warp].height + sections[weft].height);
          if (is_clear())
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
      return smallest_distance(
               polylines(warp), polylines(weft), 2. * needed, needed) >= needed;
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
  } // namespace Textile
} // namespace Heddle
