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
     *
     * While a solver looks for the equilibrium, surfaces may wear a skin of
     * thickness s: the quadratic part then begins at the gap s and ends at
     * d_0 + s, with d + s for d and d_0 + 2 s for d_0. The linear part is the
     * same for all s.
     */
    struct NormalLaw
    {
      /** d_0 [mm]: where the law becomes linear. */
      double transition;

      /** s [mm] */
      double skin = 0.;

      /** @return p [N/mm] for penalty k [N/mm^2], penetration d >= -s [mm]. */
      double
      pressure(const double penalty, const double penetration) const
      {
        const double d = penetration + skin, d_0 = transition + 2. * skin;
        return penalty * (d < d_0 ? d * d / (2. * d_0) : d - 0.5 * d_0);
      }

      /** @return dp/dd [N/mm^2]. */
      double
      stiffness(const double penalty, const double penetration) const
      {
        const double d = penetration + skin, d_0 = transition + 2. * skin;
        return penalty * (d < d_0 ? d / d_0 : 1.);
      }

      /** @return the energy per length, the integral of p [N]. */
      double
      energy(const double penalty, const double penetration) const
      {
        const double d = penetration + skin, d_0 = transition + 2. * skin;
        return penalty * (d < d_0 ? d * d * d / (6. * d_0)
                                  : 0.5 * d * (d - d_0) + d_0 * d_0 / 6.);
      }
    };
  } // namespace Contact
} // namespace Heddle

#endif
