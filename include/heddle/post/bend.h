#ifndef heddle_post_bend_h
#define heddle_post_bend_h

#include <heddle/contact/contact_element.h>
#include <heddle/contact/curve_list.h>
#include <heddle/system/state.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace Post
  {
    using namespace dealii;

    /** Where a fiber is bent. */
    struct Bend
    {
      double       ratio = 0.; /**< radius of the fiber over that of the bend */
      unsigned int fiber = 0;
      Point<3>     position; /**< [mm] */

      /**
       * Whether the inner side of the bend is a point, or less: then a fiber is
       * no beam there, and particles that face each other are not unique.
       */
      bool
      is_a_kink() const
      {
        return ratio >= 1.;
      }

      /** "fiber 13 is bent to 0.77 times its own radius near (1, 2, 3)". */
      std::string
      in_words() const;
    };

    /**
     * Find the place at which the smooth centerline of a fiber is curved most,
     * in radii of that fiber.
     * @note Collective; the same on all ranks.
     */
    Bend
    sharpest_bend(const System::State &state);

    /**
     * A contact of fibers that are bent around each other. The particles that
     * face each other at p follow from one equation, whose derivative along the
     * fibers is $|t_a + \sigma t_b|^2 + c \cdot (\kappa_a - \kappa_b)$ with
     * the connection c and the curvatures $\kappa$ (theory.md 2.1). Where the
     * second part takes away the first one they are not unique: two hairpins
     * that hang in each other at a right angle come there when they are bent to
     * twice their radius, one around a straight fiber when to its radius.
     */
    struct BentContact
    {
      double       taken = 0.; /**< part of the derivative that is taken [-] */
      Bend         bend;       /**< of the fiber that is bent more there */
      unsigned int other = 0;  /**< the fiber that it touches */

      /**
       * So near to that point that forces may jump, and bent to less than three
       * times the radius: hairpins at a right angle, bent to 2.7 R. They find
       * no equilibrium from 2.1 R on.
       */
      bool
      is_tight() const;

      /** "fiber 13 is bent to 2.4 times its own radius near (1, 2, 3), where it
       * touches fiber 7". */
      std::string
      in_words() const;
    };

    /**
     * Find the contact that is nearest to that point, of @p elements with
     * forces, of fibers on @p curves.
     * @note Collective; the same on all ranks.
     */
    BentContact
    tightest_contact(const System::FiberSpace                   &space,
                     const Contact::CurveList                   &curves,
                     const std::vector<Contact::ContactElement> &elements);
  } // namespace Post
} // namespace Heddle

#endif
