#ifndef heddle_contact_friction_law_h
#define heddle_contact_friction_law_h

#include <deal.II/base/tensor.h>

#include <algorithm>

namespace Heddle
{
  namespace Contact
  {
    using namespace dealii;

    /**
     * Coulomb's law with a reversible tangential displacement u_r before slip
     * (Durville, "Approach of the constitutive material behaviour of textile
     * composites through simulation"): for the displacement u since the contact
     * was free of friction,
     * @f[ t = \mu f \frac{u}{u_r} \;(|u| < u_r), \qquad
     *     t = \mu f \frac{u}{|u|} \;(|u| \ge u_r), @f]
     * the derivative of a convex energy as long as the normal force f is kept.
     */
    struct FrictionLaw
    {
      double limit;      /**< mu f [N] */
      double reversible; /**< u_r [mm] */

      /** @return t for the displacement @p u, [N]. */
      Tensor<1, 3>
      force(const Tensor<1, 3> &u) const
      {
        return limit * part_of_limit(u);
      }

      /** @return t over the limit, [-]. */
      Tensor<1, 3>
      part_of_limit(const Tensor<1, 3> &u) const
      {
        return u / std::max(u.norm(), reversible);
      }

      /** @return dt/du in the plane with unit normal @p normal, [N/mm]. */
      Tensor<2, 3>
      stiffness(const Tensor<1, 3> &u, const Tensor<1, 3> &normal) const
      {
        const double size  = u.norm();
        Tensor<2, 3> plane = -1. * outer_product(normal, normal);
        for (unsigned int d = 0; d < 3; ++d)
          plane[d][d] += 1.;
        if (size > reversible)
          plane -= outer_product(u, u) / (size * size);
        return limit / std::max(size, reversible) * plane;
      }

      /** @return the integral of t, [N mm]. */
      double
      energy(const Tensor<1, 3> &u) const
      {
        return limit * energy_ratio(u);
      }

      /** @return the same over mu f, [mm]. */
      double
      energy_ratio(const Tensor<1, 3> &u) const
      {
        const double size = u.norm();
        return size < reversible ? 0.5 * size * size / reversible
                                 : size - 0.5 * reversible;
      }

      /** @return what of @p u is given back when the force goes, [mm]. */
      Tensor<1, 3>
      elastic_part(const Tensor<1, 3> &u) const
      {
        return std::min(1., reversible / std::max(u.norm(), 1e-300)) * u;
      }
    };
  } // namespace Contact
} // namespace Heddle

#endif
