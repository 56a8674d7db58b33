#ifndef heddle_base_turning_points_h
#define heddle_base_turning_points_h

#include <heddle/base/expression.h>

#include <vector>

namespace Heddle
{
  /**
   * Return the load factors between 0 and 1 at which a formula of the load
   * factor turns back, or where it begins to stay before it does so, in
   * ascending order.
   */
  std::vector<double>
  turning_points(const Expression &formula);
} // namespace Heddle

#endif
