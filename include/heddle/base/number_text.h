#ifndef heddle_base_number_text_h
#define heddle_base_number_text_h

#include <string>

namespace Heddle
{
  /**
   * Return @p value as a person writes it, "0.1" or "2.5e-07", with no more
   * than so many significant @p digits: enough of them to tell a number that
   * was given from the limit that it misses.
   */
  std::string
  number_text(const double value, const unsigned int digits = 9);
} // namespace Heddle

#endif
