#include <heddle/base/columns.h>

#include <algorithm>
#include <tuple>

namespace Heddle
{
  namespace
  {
    /** Yarns that are closer than this, over their width, lie over each other
     * and not side by side [-]. */
    constexpr double stacked = 0.5;
  } // namespace



  Columns
  columns_of(std::vector<YarnPlace> yarns)
  {
    if (yarns.empty())
      return {};
    std::sort(yarns.begin(),
              yarns.end(),
              [](const YarnPlace &left, const YarnPlace &right) {
                return std::tie(left.middle, left.width) <
                       std::tie(right.middle, right.width);
              });
    Columns columns{1, yarns.front().middle, yarns.front().middle};
    for (unsigned int i = 1; i < yarns.size(); ++i)
      {
        const double mean_width = 0.5 * (yarns[i - 1].width + yarns[i].width);
        if (yarns[i].middle - yarns[i - 1].middle > stacked * mean_width)
          {
            ++columns.n;
            columns.last = yarns[i].middle;
          }
      }
    return columns;
  }
} // namespace Heddle
