#ifndef heddle_textile_clearance_h
#define heddle_textile_clearance_h

#include <heddle/base/polyline.h>

#include <vector>

namespace Heddle
{
  namespace Textile
  {
    using namespace dealii;

    /**
     * Return the smallest distance between a polyline of @p first and one of
     * @p second, or @p enough if that is smaller [mm]. The search ends as soon
     * as a distance below @p too_close is found, and returns that one: it may
     * then not be the smallest.
     */
    double
    smallest_distance(const std::vector<Polyline> &first,
                      const std::vector<Polyline> &second,
                      const double                 enough,
                      const double                 too_close);
  } // namespace Textile
} // namespace Heddle

#endif
