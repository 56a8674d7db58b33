#ifndef heddle_contact_elastic_approach_h
#define heddle_contact_elastic_approach_h

namespace Heddle
{
  namespace Contact
  {
    /** What of a fiber says how far another one is pressed into it. */
    struct PressedFiber
    {
      double radius;        /**< [mm] */
      double plane_modulus; /**< E / (1 - nu^2) across the fiber [MPa] */
    };

    /**
     * By how much the axes of two elastic cylinders come closer than the sum of
     * their radii where @p force [N] presses them together and they cross at
     * @p angle [rad], not zero. Hertz: the contact is an ellipse of the
     * half-axes a and b = k a, with the modulus e of the complete elliptic
     * integrals K and E, e^2 = 1 - k^2,
     * @f[ a^3 = \frac{3 F E(e)}{2 \pi E^* k^2 (A + B)}, \qquad
     *     \delta = \frac{3 F K(e)}{2 \pi a E^*}, \qquad
     *     \frac{E(e) / k^2 - K(e)}{K(e) - E(e)} = \frac{B}{A}, @f]
     * where the surfaces part by $A x^2 + B y^2$ and $1 / E^*$ is the sum of
     * the inverse moduli (K. L. Johnson, Contact Mechanics, 1985, section 4.2).
     * At a right angle and of equal radii R it is
     * $(9 F^2 / 16 E^{*2} R)^{1/3}$.
     * @return [mm]
     */
    double
    crossing_approach(const double        force,
                      const double        angle,
                      const PressedFiber &a,
                      const PressedFiber &b);

    /**
     * The same of parallel cylinders and a force per length @p pressure [N/mm].
     * Half of the width of the contact is
     * $w = \sqrt{4 p R^* / \pi E^*}$, $1 / R^* = 1 / R_a + 1 / R_b$, and each
     * axis comes nearer to it by
     * $\frac{p}{\pi E_i} \left( 2 \ln \frac{4 R_i}{w} - 1 \right)$
     * (Johnson, section 5.6). Where w is so large that the bracket falls below
     * 1, and the approach would become less for more force, it is taken for 1.
     * @return [mm]
     */
    double
    line_approach(const double        pressure,
                  const PressedFiber &a,
                  const PressedFiber &b);
  } // namespace Contact
} // namespace Heddle

#endif
