#ifndef heddle_post_bend_h
#define heddle_post_bend_h

#include <heddle/system/state.h>

#include <string>

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
  } // namespace Post
} // namespace Heddle

#endif
