#ifndef heddle_textile_point_order_h
#define heddle_textile_point_order_h

#include <heddle/base/polyline.h>

namespace Heddle
{
  namespace Textile
  {
    /** Whether points of a fiber may be in their order along it. */
    struct PointOrder
    {
      /** Inner points at which the way from point to point turns by more than
       * 90 degrees. */
      unsigned int n_turns = 0;

      /**
       * How many times as long that way is as the one that goes to the nearest
       * point that is left, from the one that is farthest from the middle. 1
       * where fewer than a quarter of the inner points are turns: then it is
       * not looked for. Of fibers of many points the first thousand tell.
       */
      double excess = 1.;

      /** Points that were shuffled: smooth fibers, known at more than a few
       * points, turn nowhere. */
      bool
      is_lost() const
      {
        return excess > 2.;
      }
    };

    /** Look at points, no two of which that follow each other are the same. */
    PointOrder
    order_of(const Polyline &points);

    /**
     * The number, from 0, of the first of these points at which the way goes
     * straight back, and lies on itself over @p length or more [mm]; 0 if there
     * is none.
     */
    unsigned int
    folded_at(const Polyline &points, const double length);
  } // namespace Textile
} // namespace Heddle

#endif
