#ifndef heddle_contributions_volume_in_box_h
#define heddle_contributions_volume_in_box_h

#include <heddle/system/state.h>

#include <deal.II/base/bounding_box.h>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /**
     * Return the volume of the owned fibers in @p box: the length of their axes
     * as they are, as far as it lies inside, times the area of the section
     * [mm^3]. Where a fiber passes a side aslant that is its volume inside, but
     * along a side it counts as a whole, or not at all.
     */
    double
    volume_in_box(const System::State &state, const BoundingBox<3> &box);
  } // namespace Contributions
} // namespace Heddle

#endif
