#ifndef heddle_textile_linear_density_h
#define heddle_textile_linear_density_h

#include <heddle/textile/weave_description.h>

#include <string>

namespace Heddle
{
  namespace Textile
  {
    /**
     * Let the fibers of @p yarns, whose radius is that of a filament so far,
     * stand for all filaments of a yarn of @p tex: of a total area
     * @f[ A = \frac{T}{1000\, \rho}, \qquad T \text{ in tex}, \quad
     *     \rho \text{ in g/cm}^3, \quad A \text{ in mm}^2, @f]
     * they get the radius $R$ with $n \pi R^2 = A$. Throws InputError, which
     * begins with @p where, if the density is not known, or if the yarn has
     * fewer filaments than fibers.
     */
    void
    lump_filaments(YarnFamily        &yarns,
                   const double       tex,
                   const std::string &where);

    /** What a yarn weighs [tex]; 0 if the density is not known. */
    double
    linear_density(const YarnFamily &yarns);

    /**
     * "68 tex, 411 filaments by 36 fibers of radius 0.0152 mm, 20 yarns per
     * cm", for yarns that lie @p spacing [mm] apart.
     */
    std::string
    yarns_in_words(const YarnFamily &yarns, const double spacing);
  } // namespace Textile
} // namespace Heddle

#endif
