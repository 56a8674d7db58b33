#ifndef heddle_contact_projected_crossing_h
#define heddle_contact_projected_crossing_h

#include <heddle/contact/curve.h>

namespace Heddle
{
  namespace Contact
  {
    using namespace dealii;

    /** Two particles that lie above each other. */
    struct ProjectedCrossing
    {
      /** Arc lengths; negative: none known [mm]. */
      double s_a = -1., s_b = -1.;

      /** Height of a above b [mm]. */
      double height = 0.;

      /**
       * The direction normal to both curves, with a z-component of 1: the
       * height changes by its product with the motion of a less that of b.
       */
      Tensor<1, 3> normal;
    };

    /**
     * Find where the projections of two curves on the xy-plane intersect. The
     * search starts from the particles in @p crossing or, if that fails or none
     * are known, from the knots of the curves that are closest in projection.
     *
     * @return whether they intersect, at an angle. If not, @p crossing knows
     * no particles.
     */
    bool
    find_projected_crossing(const Curve       &a,
                            const Curve       &b,
                            ProjectedCrossing &crossing);
  } // namespace Contact
} // namespace Heddle

#endif
