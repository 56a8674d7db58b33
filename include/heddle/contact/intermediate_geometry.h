#ifndef heddle_contact_intermediate_geometry_h
#define heddle_contact_intermediate_geometry_h

#include <heddle/contact/curve.h>
#include <heddle/contact/facing_particles.h>

#include <utility>

namespace Heddle
{
  namespace Contact
  {
    using namespace dealii;

    /**
     * The intermediate geometry of two close fibers a and b, of orientation
     * $\sigma = \pm 1$ (whether they run the same way): the curve
     * $x(p) = \frac12 [x_a(s_a) + x_b(s_b)]$ along its coordinate
     * $p = s_a + \sigma s_b$, twice its arc length.
     *
     * The particles at p are those in one plane normal to it,
     * @f[ (x_a - x_b) \cdot (t_a + \sigma t_b) = 0, @f]
     * which are also those of *stationary distance* among all with the same p.
     * So the derivative of their distance with respect to the configuration is
     * $n \cdot (\delta x_a - \delta x_b)$ exactly, although they move along the
     * fibers while the configuration changes; and exchanging a and b changes
     * nothing. At the end of a fiber its last particle faces a further part of
     * the other: the end is round.
     */
    class IntermediateGeometry
    {
    public:
      /**
       * @p min_separation [mm]: of a fiber with itself, the least difference
       * of arc lengths of particles that may touch; 0 for two fibers.
       */
      IntermediateGeometry(const Curve &a,
                           const Curve &b,
                           const int    orientation,
                           const double min_separation = 0.)
        : a(a)
        , b(b)
        , orientation(orientation)
        , min_separation(min_separation)
      {
      }

      /** Range of p in which there are particles of both fibers. */
      std::pair<double, double>
      range() const;

      /**
       * Return the particles at @p p, found from the guess @p q of
       * $s_a - \sigma s_b$, which is set to what was found.
       */
      FacingParticles
      facing(const double p, double &q) const;

      /**
       * Return the p beyond or before which the particle at @p end faces a
       * range of the other fiber: there it faces one particle as all others do.
       * Found from the guess @p p, and not to be trusted unchecked.
       */
      double
      kink(const FacingEnd end, const double p) const;

      /** Range of q in which there are particles of both fibers at @p p. */
      std::pair<double, double>
      range_of_q(const double p) const;

      const Curve  a, b;
      const int    orientation;
      const double min_separation; /**< as for the constructor [mm] */
    };
  } // namespace Contact
} // namespace Heddle

#endif
