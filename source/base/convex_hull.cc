#include <heddle/base/convex_hull.h>

#include <algorithm>

namespace Heddle
{
  std::vector<Point<2>>
  convex_hull(std::vector<Point<2>> points)
  {
    const auto turn =
      [](const Point<2> &a, const Point<2> &b, const Point<2> &c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
      };
    std::sort(
      points.begin(), points.end(), [](const Point<2> &a, const Point<2> &b) {
        return a[0] < b[0] || (a[0] == b[0] && a[1] < b[1]);
      });

    std::vector<Point<2>> hull;
    for (unsigned int side = 0; side < 2; ++side)
      {
        const unsigned int start = hull.size();
        for (const Point<2> &p : points)
          {
            while (hull.size() >= start + 2 &&
                   turn(hull[hull.size() - 2], hull.back(), p) <= 0.)
              hull.pop_back();
            hull.push_back(p);
          }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
      }
    return hull;
  }



  double
  polygon_area(const std::vector<Point<2>> &polygon)
  {
    double twice = 0.;
    for (unsigned int i = 0; i < polygon.size(); ++i)
      {
        const Point<2> &a = polygon[i];
        const Point<2> &b = polygon[(i + 1) % polygon.size()];
        twice += a[0] * b[1] - a[1] * b[0];
      }
    return 0.5 * twice;
  }
} // namespace Heddle
