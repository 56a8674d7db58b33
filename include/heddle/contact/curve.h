#ifndef heddle_contact_curve_h
#define heddle_contact_curve_h

#include <deal.II/base/tensor.h>

#include <algorithm>

namespace Heddle
{
  namespace Contact
  {
    using namespace dealii;

    /** A point of a curve with its first two derivatives in arc length. */
    struct CurvePoint
    {
      Tensor<1, 3> position;
      Tensor<1, 3> tangent;   /**< [-] */
      Tensor<1, 3> curvature; /**< [1/mm] */
    };

    /**
     * View of the smooth axis of one fiber: a C1 piecewise cubic given by
     * positions and tangents at its knots. Owns nothing.
     */
    class Curve
    {
    public:
      Curve(const unsigned int  n_knots,
            const double       *arc_lengths,
            const Tensor<1, 3> *positions,
            const Tensor<1, 3> *tangents,
            const double        radius)
        : n_knots(n_knots)
        , arc_lengths(arc_lengths)
        , positions(positions)
        , tangents(tangents)
        , radius(radius)
      {
      }

      double
      length() const
      {
        return arc_lengths[n_knots - 1];
      }

      /** Return the i with knot i <= s < knot i + 1; outside, the nearest one.
       */
      unsigned int
      interval(const double s) const;

      /**
       * Return the point at arc length @p s. @p interval is where the search
       * for its knots starts, and is set to where it ended.
       */
      CurvePoint
      evaluate(const double s, unsigned int &interval) const;

    private:
      /** The interval of @p s, sought from the interval @p from. */
      unsigned int
      search(const double s, unsigned int from) const;

    public:
      const unsigned int        n_knots;
      const double *const       arc_lengths; /**< [mm] */
      const Tensor<1, 3> *const positions;   /**< [mm] */
      const Tensor<1, 3> *const tangents;    /**< [-] */
      const double              radius;      /**< of the fiber's section [mm] */
    };



    inline unsigned int
    Curve::search(const double s, unsigned int from) const
    {
      while (from > 0 && s < arc_lengths[from])
        --from;
      while (from + 2 < n_knots && s >= arc_lengths[from + 1])
        ++from;
      return from;
    }



    inline unsigned int
    Curve::interval(const double s) const
    {
      // Nearly all fibers have equal intervals: this guess is then right.
      const double i = s / length() * (n_knots - 1);
      return search(s, std::min<unsigned int>(n_knots - 2, std::max(0., i)));
    }



    inline CurvePoint
    Curve::evaluate(const double s, unsigned int &interval) const
    {
      const unsigned int i = search(s, interval);
      interval             = i;

      const double h     = arc_lengths[i + 1] - arc_lengths[i];
      const double per_h = 1. / h;
      const double t     = (s - arc_lengths[i]) * per_h;

      // x = x0 + t h (m0 + t (c + t d)) with
      // c = 3 D - 2 m0 - m1, d = m0 + m1 - 2 D and D the mean slope.
      CurvePoint point;
      for (unsigned int k = 0; k < 3; ++k)
        {
          const double m0 = tangents[i][k], m1 = tangents[i + 1][k];
          const double D = (positions[i + 1][k] - positions[i][k]) * per_h;
          const double c = 3. * D - 2. * m0 - m1, d = m0 + m1 - 2. * D;
          point.position[k]  = positions[i][k] + t * h * (m0 + t * (c + t * d));
          point.tangent[k]   = m0 + t * (2. * c + 3. * t * d);
          point.curvature[k] = (2. * c + 6. * t * d) * per_h;
        }
      return point;
    }
  } // namespace Contact
} // namespace Heddle

#endif
