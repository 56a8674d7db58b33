#include <heddle/base/exceptions.h>
#include <heddle/textile/linear_density.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace Heddle
{
  namespace Textile
  {
    using namespace dealii;

    namespace
    {
      double
      n_fibers(const Packing &packing)
      {
        return double(packing.n_bundles) * packing.fibers_per_bundle;
      }



      /** How many filaments a fiber stands for. */
      double
      filaments_per_fiber(const Packing &packing)
      {
        const double ratio = packing.filament_radius > 0.
                               ? packing.radius / packing.filament_radius
                               : 1.;
        return ratio * ratio;
      }
    } // namespace



    void
    lump_filaments(YarnFamily        &yarns,
                   const double       tex,
                   const std::string &where)
    {
      Packing           &packing = yarns.packing;
      std::ostringstream given;
      given << where << "/Linear density is " << tex << " tex";
      require(yarns.density > 0.,
              given.str() +
                ", but Density is 0; give the density of the fibers.");
      require(packing.radius > 0.,
              given.str() +
                ", but Fiber radius is 0; give that of a filament.");
      packing.filament_radius = packing.radius;
      packing.radius          = std::sqrt(
        tex / (1000. * yarns.density * numbers::PI * n_fibers(packing)));
      const double n_filaments =
        n_fibers(packing) * filaments_per_fiber(packing);
      if (n_filaments >= n_fibers(packing) * (1. - 1e-6))
        return;
      given << ", which are " << n_filaments << " filaments of radius "
            << packing.filament_radius << " mm, fewer than the "
            << n_fibers(packing)
            << " fibers of a yarn; give fewer fibers, or another \"Fiber "
               "radius\", that of a filament.";
      throw InputError(given.str());
    }



    double
    linear_density(const YarnFamily &yarns)
    {
      const double radius = yarns.packing.radius;
      return 1000. * yarns.density * numbers::PI * radius * radius *
             n_fibers(yarns.packing);
    }



    std::string
    yarns_in_words(const YarnFamily &yarns, const double spacing)
    {
      const Packing     &packing = yarns.packing;
      std::ostringstream text;
      text << std::setprecision(3) << linear_density(yarns) << " tex, ";
      if (packing.filament_radius > 0.)
        text << std::lround(n_fibers(packing) * filaments_per_fiber(packing))
             << " filaments by ";
      text << std::lround(n_fibers(packing)) << " fibers of radius "
           << packing.radius << " mm, " << 10. / spacing << " yarns per cm";
      return text.str();
    }
  } // namespace Textile
} // namespace Heddle
