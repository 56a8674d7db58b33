#ifndef heddle_textile_fiber_axis_h
#define heddle_textile_fiber_axis_h

#include <heddle/base/polyline.h>
#include <heddle/textile/fiber_path.h>

namespace Heddle
{
  namespace Textile
  {
    /** Where a fiber lies in a fabric: what the mesh of a matrix needs of it.
     */
    struct FiberAxis
    {
      /** At least two points, no two consecutive ones alike [mm]. */
      Polyline points;

      /** Of the circular section [mm]. */
      double radius = 0.;

      /** Number of the yarn, or no_id. */
      unsigned int yarn_id = no_id;
    };
  } // namespace Textile
} // namespace Heddle

#endif
