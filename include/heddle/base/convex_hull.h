#ifndef heddle_base_convex_hull_h
#define heddle_base_convex_hull_h

#include <deal.II/base/point.h>

#include <vector>

namespace Heddle
{
  using namespace dealii;

  /** Corners of the convex hull of @p points, counter-clockwise. */
  std::vector<Point<2>>
  convex_hull(std::vector<Point<2>> points);

  /** Area of a polygon, positive if it runs counter-clockwise. */
  double
  polygon_area(const std::vector<Point<2>> &polygon);
} // namespace Heddle

#endif
