#ifndef heddle_textile_packing_h
#define heddle_textile_packing_h

#include <deal.II/base/point.h>

#include <cstdint>
#include <string>
#include <vector>

namespace Heddle
{
  namespace Textile
  {
    using namespace dealii;

    /** How the fibers of a yarn are arranged in its section. */
    enum class Layout
    {
      /** Bundles side by side, each of staggered rows (12 fibers = 4 x 3). */
      rows,
      /** The roundest piece of a hexagonal lattice; bundles are its sectors. */
      hexagonal
    };

    /** How the user names them. */
    constexpr const char *
    word(const Layout layout)
    {
      switch (layout)
        {
          case Layout::rows:
            return "rows";
          case Layout::hexagonal:
            return "hexagonal";
        }
      return nullptr;
    }



    /** What a yarn is made of, and how it is packed. */
    struct Packing
    {
      unsigned int n_bundles         = 1;
      unsigned int fibers_per_bundle = 12;

      /** Radius of a fiber [mm]. */
      double radius = 0.0045;

      /**
       * Radius of the filaments for which a fiber stands that is thicker than
       * one [mm]; 0: it is one.
       */
      double filament_radius = 0.;

      Layout layout = Layout::rows;

      /** Distance between the axes of neighbours over the radius, >= 2 [-]. */
      double spacing = 2.04;

      /**
       * Random shift of each fiber, as a fraction of the largest one at which
       * neighbours cannot touch, 0 to 1 [-].
       */
      double perturbation = 0.;

      /** Another seed, another yarn. Inactive without perturbation. */
      std::uint64_t seed = 1;

      unsigned int
      n_fibers() const
      {
        return n_bundles * fibers_per_bundle;
      }
    };



    /** Section of a yarn: across it, and through the thickness of the fabric.
     */
    struct PackedSection
    {
      /** Centers of the fibers, bundle by bundle, about the axis [mm]. */
      std::vector<Point<2>> positions;

      /** Of the box that holds all the fibers, not only their axes [mm]. */
      double width  = 0.;
      double height = 0.;

      /** Distance from the axis of the yarn to the farthest fiber axis [mm]. */
      double radius = 0.;
    };



    /**
     * Throw an InputError that begins with @p where if the packing has no
     * fibers, a radius that is not positive, a spacing below 2 or a
     * perturbation outside [0,1].
     */
    void
    check_packing(const Packing &packing, const std::string &where);



    /**
     * Return the section of yarn number @p yarn. No two fibers overlap. The
     * random shifts depend on the seed, the yarn and the fiber alone, so every
     * rank and every standard library gives the same ones. Width, height and
     * radius are those of the unperturbed section and equal for all yarns.
     *
     * @pre check_packing() accepts the packing.
     */
    PackedSection
    pack_yarn(const Packing &packing, const unsigned int yarn);
  } // namespace Textile
} // namespace Heddle

#endif
