#ifndef heddle_base_polyline_h
#define heddle_base_polyline_h

#include <deal.II/base/tensor.h>

#include <vector>

namespace Heddle
{
  using namespace dealii;

  /** Points along a fiber, joined by straight lines [mm]. */
  using Polyline = std::vector<Tensor<1, 3>>;
} // namespace Heddle

#endif
