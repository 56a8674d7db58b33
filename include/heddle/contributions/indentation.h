#ifndef heddle_contributions_indentation_h
#define heddle_contributions_indentation_h

#include <heddle/base/archive.h>
#include <heddle/contact/contact_element.h>
#include <heddle/contact/curve_list.h>
#include <heddle/system/fiber_space.h>

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /**
     * How far elastic fibers would be pressed into each other by the forces
     * that contacts bear, which the penetration threshold does not let them.
     *
     * Under given forces harder contacts change little. Where supports or
     * neighbours prescribe how near fibers come, forces grow until something
     * else yields: a structure of the stiffness K that comes nearer by x has
     * the force $F = K x$ and the energy $F x / 2$. With the approach
     * $\delta \sim F^{2/3}$ of elastic contact (Hertz) beside it the part y of
     * the force is left,
     * @f[ y + r\,y^{2/3} = 1, \qquad
     *     r = \frac{K \delta(F)}{F} = \frac{F \delta(F)}{2 \cdot F x / 2}. @f]
     * Summed up over all contacts, and over all energy, some of which may have
     * nothing to do with contact, this r says too little rather than too much.
     */
    struct Indentation
    {
      /** The deepest, over the smaller radius [-]. */
      double       ratio   = 0.;
      unsigned int fiber_a = 0;
      unsigned int fiber_b = 0;
      Point<3>     position;        /**< of that contact [mm] */
      double       force   = 0.;    /**< of that contact [N], or [N/mm] */
      bool         is_line = false; /**< whether its force is per length */
      double       allowed = 0.; /**< threshold, penetration over radius [-] */

      /** Forces times what is missing to those depths, of all contacts [N mm].
       */
      double work = 0.;

      /** All elastic energy at that moment, to be set by who knows it [N mm].
       */
      double energy = 0.;

      /** r [-] */
      double
      work_ratio() const;

      /** 1 / y: how many times too large forces are if motion is prescribed. */
      double
      excess_of_force() const;

      /**
       * Whether it is to be told: deeper than a tenth of the radius and twice
       * the threshold, and from r = 1 on, where forces are 2.3 times too large.
       */
      bool
      is_deep() const;

      /** What is to be said of it, or nothing. */
      std::string
      in_words() const;

      void
      save(ArchiveWriter &archive, const std::string &name) const;

      void
      load(const ArchiveReader &archive, const std::string &name);
    };

    /**
     * Find it for contact elements, cell by cell, of fibers on @p curves.
     *
     * Elements that follow each other make up one contact. If it is as long as
     * straight fibers of this angle touch at this depth it is a crossing, whose
     * force as a whole counts; others are lines, where the force per length
     * does, in each cell. The fibers' modulus across is that of their section,
     * $E / (1 - \nu^2) = 2 S / (1 - \nu)$.
     * @note Collective; the same on all ranks.
     */
    Indentation
    find_indentation(const System::FiberSpace                   &space,
                     const Contact::CurveList                   &curves,
                     const std::vector<Contact::ContactElement> &elements,
                     const double                                threshold);
  } // namespace Contributions
} // namespace Heddle

#endif
