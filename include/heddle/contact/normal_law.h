#ifndef heddle_contact_normal_law_h
#define heddle_contact_normal_law_h

namespace Heddle
{
  namespace Contact
  {
    /**
     * Force per length p that answers to the penetration d of two surfaces,
     * quadratic first and linear beyond (Durville, "Algorithmical and numerical
     * aspects"):
     * @f[ p = k \frac{d^2}{2 d_0} \;(d < d_0), \qquad
     *     p = k \left(d - \frac{d_0}{2}\right) \;(d \ge d_0), @f]
     * so that force and stiffness are continuous when contact begins.
     */
    struct NormalLaw
    {
      /** d_0 [mm]: where the law becomes linear. */
      double transition;

      /** @return p [N/mm] for penalty k [N/mm^2], penetration d >= 0 [mm]. */
      double
      pressure(const double penalty, const double penetration) const
      {
        return penetration < transition
                 ? penalty * penetration * penetration / (2. * transition)
                 : penalty * (penetration - 0.5 * transition);
      }

      /** @return dp/dd [N/mm^2]. */
      double
      stiffness(const double penalty, const double penetration) const
      {
        return penetration < transition ? penalty * penetration / transition
                                        : penalty;
      }

      /** @return the energy per length, the integral of p [N]. */
      double
      energy(const double penalty, const double penetration) const
      {
        if (penetration < transition)
          return penalty * penetration * penetration * penetration /
                 (6. * transition);
        return penalty * (0.5 * penetration * (penetration - transition) +
                          transition * transition / 6.);
      }
    };
  } // namespace Contact
} // namespace Heddle

#endif
