#ifndef heddle_textile_weave_h
#define heddle_textile_weave_h

#include <heddle/textile/curve.h>
#include <heddle/textile/fiber_path.h>
#include <heddle/textile/packing.h>
#include <heddle/textile/weave_pattern.h>
#include <heddle/textile/yarn_axis.h>

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace Textile
  {
    using namespace dealii;

    /** From which geometry the initial configuration is computed. */
    enum class Start
    {
      /** Straight yarns, all in one plane, running through each other. */
      interpenetrating,
      /** Yarns bent over and under each other, clear of each other. */
      crimped
    };



    /** All the warp yarns, or all the weft yarns. */
    struct YarnFamily
    {
      unsigned int n_yarns = 4;
      Packing      packing;

      /** Turns of the fibers about the yarn per length of the fabric [1/mm]. */
      double twist = 0.;

      /**
       * Distance between the axes of neighbouring yarns [mm]; 0: the width of
       * the yarn and 0.8 times the height of the yarns that pass between.
       */
      double spacing = 0.;
    };



    /** A woven sample, as the user describes it. */
    struct WeaveDescription
    {
      std::string pattern = "plain";
      YarnFamily  warp;
      YarnFamily  weft;

      /** Yarn beyond its last crossing, in spacings of those it crosses [-]. */
      double end_length = 0.5;

      Start start = Start::crimped;

      /**
       * Height of the yarn axes at the crossings of the crimped start, over a
       * quarter of the sum of both yarns' heights; 0: the smallest at which the
       * yarns are clear of each other [-].
       */
      double crimp_factor = 0.;

      /** Part of the spacing over which a yarn changes its side, (0,1] [-]. */
      double crimp_transition = 1.;
    };



    /** Where a warp yarn and a weft yarn cross. */
    struct Crossing
    {
      unsigned int warp_yarn; /**< FiberPath::yarn_id of the warp yarn */
      unsigned int weft_yarn; /**< FiberPath::yarn_id of the weft yarn */
      Point<2>     center;    /**< x and y of the straight yarns' axes [mm] */
      bool         warp_on_top;
    };



    /**
     * The fibers of a woven sample before any mechanics. Warp yarns run along
     * x, weft yarns along y, z is the thickness; the middle of the sample is
     * the origin. Yarns are numbered warp first, from low to high y, then weft,
     * from low to high x; fibers yarn by yarn, bundle by bundle.
     *
     * The crimped start bends each yarn along a YarnAxis. The section of the
     * yarn stays normal to its axis if the yarns get clear of each other so, at
     * up to twice the height at which they would just touch if they were flat
     * ribbons: then fibers of one yarn are as far from each other as in the
     * straight yarn. Wide yarns close to each other leave no room for this;
     * their sections stay upright, every fiber has the same height curve, and
     * fibers of one yarn come up to about half a radius too close on the slope.
     */
    class Weave
    {
    public:
      /**
       * Throws InputError if the description is impossible, or if no crimp up
       * to six times the flat one gets the yarns clear of each other.
       */
      explicit Weave(const WeaveDescription &description);

      /**
       * Return all fibers with @p n_elements + 1 knots each, equally spaced in
       * arc length.
       *
       * Their reference length is the arc length of their own path, so that
       * they start free of axial strain: the ends are free to slide along the
       * yarn, and what is too long leaves through them.
       */
      std::vector<FiberPath>
      paths(const unsigned int n_elements) const;

      /** All crossings, warp yarn by warp yarn. */
      std::vector<Crossing>
      crossings() const;

      /** Distance between neighbouring warp yarns [mm]. */
      double
      warp_spacing() const
      {
        return spacings[0];
      }

      /** Distance between neighbouring weft yarns [mm]. */
      double
      weft_spacing() const
      {
        return spacings[1];
      }

      /** Height of the yarn axes at the crossings; 0 if straight [mm]. */
      double
      amplitude() const
      {
        return crimp_amplitude;
      }

      /** Whether the sections of the yarns are normal to their axes. */
      bool
      has_normal_sections() const
      {
        return normal_sections;
      }

    private:
      enum Direction
      {
        warp = 0,
        weft = 1
      };

      const YarnFamily &
      family(const Direction direction) const
      {
        return direction == warp ? description.warp : description.weft;
      }

      /** Check what concerns one family alone. */
      void
      check(const Direction direction) const;

      /** Fix spacings and lengths. */
      void
      lay_out();

      /** Choose amplitude and sections of the crimped start. */
      void
      find_crimp();

      /** Whether no warp fiber touches a weft fiber as things stand. */
      bool
      is_clear() const;

      /** Position across the fabric of yarn number @p i of its family [mm]. */
      double
      position(const Direction direction, const unsigned int i) const;

      YarnAxis
      axis(const Direction direction, const unsigned int i) const;

      /** Axes of the fibers of one yarn, on [-length/2, length/2]. */
      std::vector<Curve>
      fibers(const Direction direction, const unsigned int i) const;

      /** Fine polygons of all fibers of a family. */
      std::vector<std::vector<Tensor<1, 3>>>
      polylines(const Direction direction) const;

      WeaveDescription description;
      WeavePattern     pattern;
      YarnSection      sections[2];
      double           spacings[2];
      double           lengths[2];
      double           crimp_amplitude = 0.;
      bool             normal_sections = true;
    };
  } // namespace Textile
} // namespace Heddle

#endif
