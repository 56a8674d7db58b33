#ifndef heddle_base_polyline_h
#define heddle_base_polyline_h

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace Heddle
{
  using namespace dealii;

  /** Points along a fiber, joined by straight lines [mm]. */
  using Polyline = std::vector<Tensor<1, 3>>;

  /** Where a point goes; nothing: it stays. */
  using PointMap = std::function<Tensor<1, 3>(const Tensor<1, 3> &)>;

  inline void
  move_points(Polyline &line, const PointMap &map)
  {
    if (map)
      std::transform(line.begin(), line.end(), line.begin(), map);
  }
} // namespace Heddle

#endif
