#ifndef heddle_textile_extent_h
#define heddle_textile_extent_h

#include <algorithm>
#include <limits>

namespace Heddle
{
  namespace Textile
  {
    /** The interval that holds all numbers added; without any, low > high. */
    struct Extent
    {
      double low  = std::numeric_limits<double>::max();
      double high = -std::numeric_limits<double>::max();

      void
      add(const double value)
      {
        low  = std::min(low, value);
        high = std::max(high, value);
      }
    };
  } // namespace Textile
} // namespace Heddle

#endif
