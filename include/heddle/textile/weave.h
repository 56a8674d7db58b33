#ifndef heddle_textile_weave_h
#define heddle_textile_weave_h

#include <heddle/base/polyline.h>
#include <heddle/textile/fiber_path.h>
#include <heddle/textile/packing.h>
#include <heddle/textile/parametric_curve.h>
#include <heddle/textile/weave_description.h>
#include <heddle/textile/weave_pattern.h>
#include <heddle/textile/yarn_axis.h>

#include <deal.II/base/point.h>

#include <utility>
#include <vector>

namespace Heddle
{
  namespace Textile
  {
    using namespace dealii;

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
     * The crimped start bends each yarn along a YarnAxis. The sections of the
     * yarn stay normal to it if the yarns get clear of each other so, at up to
     * 1.5 times the height at which flat ribbons would just touch. Then fibers
     * of one yarn keep the distance that they have in the straight yarn, as
     * long as the axis is not bent more sharply than the yarn is thick. Wide
     * yarns close to each other leave no room for this: their sections stay
     * upright, every fiber follows the same height curve, and fibers of one
     * yarn come up to half a radius too close to each other on the slope. Where
     * not even this gets them clear, the edges of crossing yarns overlap, but
     * every fiber starts on its side of every other.
     */
    class Weave
    {
    public:
      /**
       * Throws InputError if the description is impossible, or if no crimp up
       * to six times the flat one gets the yarns past each other.
       */
      explicit Weave(const WeaveDescription &description);

      /**
       * Return all fibers with @p n_elements + 1 knots each, equally spaced in
       * arc length.
       *
       * Their reference length is the arc length of their own path, so that
       * they start free of axial strain: the ends are free to slide along the
       * yarn, and what is too long leaves through them.
       *
       * Warp and weft yarns take turns: fibers that follow each other, as a
       * rank owns them, are those of a strip of both families, and fibers of
       * two ranks cross in two corners of the fabric instead of all over.
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

      /** Whether no warp fiber touches a weft fiber, and none runs back. */
      bool
      is_clear() const;

      /** What is to be said of yarns that slip off, begin in each other, or are
       * held by none. */
      std::vector<std::string>
      notes() const;

    private:
      enum Direction
      {
        warp = 0,
        weft = 1
      };

      static Direction
      other(const Direction direction)
      {
        return direction == warp ? weft : warp;
      }

      const YarnFamily &
      family(const Direction direction) const
      {
        return direction == warp ? description.warp : description.weft;
      }

      /** Of yarns that end within the last ones that they cross, off which
       * their fibers slip, or nothing, like those below. */
      std::string
      short_ends() const;

      /** Of yarns that are wider than they are apart. */
      std::string
      wide_yarns() const;

      /** Of a yarn that lies on the same side of all others. */
      std::string
      loose_yarn() const;

      /** Refuse what is larger than any fabric. */
      void
      check_size(const Direction direction) const;

      /** Fix sections, spacings and lengths. */
      void
      lay_out();

      /** Choose amplitude and sections of the crimped start. */
      void
      find_crimp();

      /**
       * Try crimp factors from @p smallest to @p largest, with sections normal
       * to the axis or upright, until @p goal is reached; tell whether it was.
       */
      bool
      raise_until(bool (Weave::*goal)() const,
                  const bool   normal,
                  const double smallest,
                  const double largest);

      /**
       * Whether each warp fiber passes each weft fiber on its side, by half the
       * distance at which they would touch or more, as things stand.
       * @pre The sections are upright.
       */
      bool
      is_in_order() const;

      /** Position across the fabric of yarn number @p i of its family [mm]. */
      double
      position(const Direction direction, const unsigned int i) const;

      YarnAxis
      axis(const Direction direction, const unsigned int i) const;

      /** All yarns, warp and weft in turn. */
      std::vector<std::pair<Direction, unsigned int>>
      yarns_in_turn() const;

      /** Axes of the fibers of one yarn, on [-length/2, length/2]. */
      std::vector<ParametricCurve>
      fibers(const Direction direction, const unsigned int i) const;

      /** Fine polygons of all fibers of a family. */
      std::vector<Polyline>
      polylines(const Direction direction) const;

      WeaveDescription description;
      WeavePattern     pattern;
      PackedSection    sections[2];
      double           spacings[2];
      double           lengths[2];
      double           crimp_amplitude = 0.;
      bool             normal_sections = true;
    };
  } // namespace Textile
} // namespace Heddle

#endif
