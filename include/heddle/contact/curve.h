#ifndef heddle_contact_curve_h
#define heddle_contact_curve_h

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <utility>

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
     * One interval of a curve, $x = c_0 + t (c_1 + t (c_2 + t c_3))$ with the
     * arc length t from its first knot. Plain arrays, lest Debug takes far
     * longer.
     */
    struct CurveCubic
    {
      double c0[3], c1[3], c2[3], c3[3];
    };

    /**
     * View of the smooth axis of one fiber: a C1 piecewise cubic given by
     * positions and tangents at its knots, and by the cubics between them. Only
     * those between some knots may be known. Owns nothing.
     */
    class Curve
    {
    public:
      /**
       * @p arc_lengths of all @p n_knots; @p positions, @p tangents and
       * @p cubics, as set_cubics() makes them, of the knots @p known [first,
       * second).
       */
      Curve(const unsigned int                           n_knots,
            const std::pair<unsigned int, unsigned int> &known,
            const double                                *arc_lengths,
            const Tensor<1, 3>                          *positions,
            const Tensor<1, 3>                          *tangents,
            const CurveCubic                            *cubics,
            const double                                 radius)
        : n_knots(n_knots)
        , known(known)
        , arc_lengths(arc_lengths)
        , radius(radius)
        , positions(positions)
        , tangents(tangents)
        , cubics(cubics)
      {
      }

      double
      length() const
      {
        return arc_lengths[n_knots - 1];
      }

      /** Arc length of the middle of interval @p i [mm]. */
      double
      middle(const unsigned int i) const
      {
        return 0.5 * (arc_lengths[i] + arc_lengths[i + 1]);
      }

      /** Position of knot @p i, which is known [mm]. */
      const Tensor<1, 3> &
      position(const unsigned int i) const
      {
        return positions[i - known.first];
      }

      /** Tangent there [-]. */
      const Tensor<1, 3> &
      tangent(const unsigned int i) const
      {
        return tangents[i - known.first];
      }

      /** The cubic between the knots @p i and i + 1, which are known. */
      const CurveCubic &
      cubic(const unsigned int i) const
      {
        return cubics[i - known.first];
      }

      /**
       * Return the i with knot i <= s < knot i + 1; of what is not known, the
       * nearest one that is.
       */
      unsigned int
      interval(const double s) const;

      /** The same, sought from the interval @p from. */
      unsigned int
      interval(const double s, unsigned int from) const;

      /**
       * Return the point at arc length @p s. @p interval is where the search
       * for its knots starts, and is set to where it ended.
       */
      CurvePoint
      evaluate(const double s, unsigned int &interval) const;

      /** Return the position at arc length @p s. */
      Tensor<1, 3>
      at(const double s) const;

      const unsigned int                          n_knots;
      const std::pair<unsigned int, unsigned int> known;
      const double *const                         arc_lengths; /**< [mm] */
      const double radius; /**< of the fiber's section [mm] */

    private:
      const Tensor<1, 3> *const positions;
      const Tensor<1, 3> *const tangents;
      const CurveCubic *const   cubics;
    };



    inline unsigned int
    Curve::interval(const double s, unsigned int from) const
    {
      from = std::min(std::max(from, known.first), known.second - 2);
      while (from > known.first && s < arc_lengths[from])
        --from;
      while (from + 2 < known.second && s >= arc_lengths[from + 1])
        ++from;
      return from;
    }



    inline unsigned int
    Curve::interval(const double s) const
    {
      // Nearly all fibers have equal intervals: this guess is then right.
      const double i = s / length() * (n_knots - 1);
      return interval(s, static_cast<unsigned int>(std::max(0., i)));
    }



    inline CurvePoint
    Curve::evaluate(const double s, unsigned int &interval) const
    {
      interval                = this->interval(s, interval);
      const CurveCubic &cubic = this->cubic(interval);
      const double      t     = s - arc_lengths[interval];
      CurvePoint        point;
      for (unsigned int d = 0; d < 3; ++d)
        {
          const double bent  = cubic.c2[d] + t * cubic.c3[d];
          const double more  = bent + t * cubic.c3[d];
          point.position[d]  = cubic.c0[d] + t * (cubic.c1[d] + t * bent);
          point.tangent[d]   = cubic.c1[d] + t * (bent + more);
          point.curvature[d] = 2. * (more + t * cubic.c3[d]);
        }
      return point;
    }



    inline Tensor<1, 3>
    Curve::at(const double s) const
    {
      unsigned int i = interval(s);
      return evaluate(s, i).position;
    }



    /** Of a cubic: it lies in their convex hull [mm]. */
    using ControlPoints = std::array<Tensor<1, 3>, 4>;

    /** Those of the cubic between the knots @p i and i + 1, which are known. */
    inline ControlPoints
    control_points(const Curve &curve, const unsigned int i)
    {
      const double third =
        (curve.arc_lengths[i + 1] - curve.arc_lengths[i]) / 3.;
      return {{curve.position(i),
               curve.position(i) + third * curve.tangent(i),
               curve.position(i + 1) - third * curve.tangent(i + 1),
               curve.position(i + 1)}};
    }



    /**
     * Set the @p n_knots - 1 cubics between knots at @p arc_lengths [mm] with
     * these @p positions [mm] and @p tangents [-].
     */
    inline void
    set_cubics(const unsigned int  n_knots,
               const double       *arc_lengths,
               const Tensor<1, 3> *positions,
               const Tensor<1, 3> *tangents,
               CurveCubic         *cubics)
    {
      for (unsigned int i = 0; i + 1 < n_knots; ++i)
        {
          // With the mean slope D the polynomial in t / h has
          // c = 3 D - 2 m0 - m1 and d = m0 + m1 - 2 D after m0.
          const double per_h = 1. / (arc_lengths[i + 1] - arc_lengths[i]);
          CurveCubic  &cubic = cubics[i];
          for (unsigned int k = 0; k < 3; ++k)
            {
              const double m0 = tangents[i][k], m1 = tangents[i + 1][k];
              const double D = (positions[i + 1][k] - positions[i][k]) * per_h;
              cubic.c0[k]    = positions[i][k];
              cubic.c1[k]    = m0;
              cubic.c2[k]    = (3. * D - 2. * m0 - m1) * per_h;
              cubic.c3[k]    = (m0 + m1 - 2. * D) * per_h * per_h;
            }
        }
    }
  } // namespace Contact
} // namespace Heddle

#endif
