#ifndef heddle_textile_yarn_axis_h
#define heddle_textile_yarn_axis_h

#include <vector>

namespace Heddle
{
  namespace Textile
  {
    /**
     * Height of the axis of a yarn above the middle plane of the fabric, along
     * the yarn: $\pm a$ at the crossings, flat where the yarn floats over
     * several yarns, and half a cosine in between. In a plain weave with
     * transition 1 this is $z = \pm a \cos(\pi x / p)$. The curve is C1.
     */
    class YarnAxis
    {
    public:
      /**
       * @param spacing Distance between crossings [mm].
       * @param first Where crossing number 0 lies along the yarn [mm].
       * @param sides One repeat of the pattern, true where the yarn is on top.
       * @param amplitude The height $a$; zero for a straight yarn [mm].
       * @param transition Part of the spacing that the cosine takes, the rest
       * being flat about the crossings, 0 < transition <= 1.
       */
      YarnAxis(const double             spacing,
               const double             first,
               const std::vector<bool> &sides,
               const double             amplitude,
               const double             transition);

      /** Height at @p x [mm]. */
      double
      height(const double x) const;

      /** Derivative of the height [-]. */
      double
      slope(const double x) const;

    private:
      /** Where a point lies between two crossings. */
      struct Place
      {
        double before, after; /**< heights at the crossings */
        double phase;         /**< 0 to pi along the cosine */
      };

      Place
      locate(const double x) const;

      double            spacing;
      double            first;
      std::vector<bool> sides;
      double            amplitude;
      double            transition;
    };
  } // namespace Textile
} // namespace Heddle

#endif
