#ifndef heddle_base_number_range_h
#define heddle_base_number_range_h

#include <cmath>

namespace Heddle
{
  /**
   * Whether @p value, of a user, can be computed with: sums of squares of
   * stiffnesses, such as a modulus times the fourth power of a radius, are not
   * infinite.
   */
  inline bool
  is_in_range(const double value)
  {
    return std::abs(value) <= 1e30;
  }

  /** The same in words, after "give". */
  constexpr const char *range_in_words = "numbers between -1e30 and 1e30";
} // namespace Heddle

#endif
