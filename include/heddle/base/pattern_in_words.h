#ifndef heddle_base_pattern_in_words_h
#define heddle_base_pattern_in_words_h

#include <string>

namespace Heddle
{
  /**
   * Return in words what the pattern of a parameter allows. @p description is
   * what deal.II's pattern says of itself: for "[Double 0...MAX_DOUBLE
   * (inclusive)]" the answer is "a number of at least 0".
   */
  std::string
  pattern_in_words(const std::string &description);
} // namespace Heddle

#endif
