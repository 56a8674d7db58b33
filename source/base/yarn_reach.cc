#include <heddle/base/yarn_reach.h>

#include <algorithm>
#include <functional>

namespace Heddle
{
  namespace
  {
    /** Of a yarn's length, that a fiber should not lack at an end [-]. */
    constexpr double large_part = 0.1;

    /** From end to end of fibers of a yarn that has two ends, over their
     * lengths [-]. */
    constexpr double least_way = 0.5;



    double
    length_of(const Polyline &line)
    {
      double length = 0.;
      for (unsigned int i = 1; i < line.size(); ++i)
        length += (line[i] - line[i - 1]).norm();
      return length;
    }



    /** Whether a fiber runs from end to end of its yarn. */
    bool
    is_whole(const std::array<bool, 2> &ends)
    {
      return ends[0] && ends[1];
    }
  } // namespace



  std::vector<Polyline>
  run_one_way(std::vector<Polyline> fibers)
  {
    const Tensor<1, 3> way = fibers[0].back() - fibers[0].front();
    for (Polyline &fiber : fibers)
      if ((fiber.back() - fiber.front()) * way < 0.)
        std::reverse(fiber.begin(), fiber.end());
    return fibers;
  }



  YarnReach::YarnReach(const std::vector<Polyline> &fibers)
    : at_end(fibers.size(), {{true, true}})
  {
    double length = 0.;
    for (const Polyline &fiber : fibers)
      {
        const Tensor<1, 3> own = fiber.back() - fiber.front();
        along += own * along < 0. ? -own : own;
        length += length_of(fiber);
      }
    const double norm = along.norm();
    if (norm < least_way * length)
      return;
    along /= norm;

    std::vector<double> low, high;
    for (const Polyline &fiber : fibers)
      {
        const double a = fiber.front() * along, b = fiber.back() * along;
        low.push_back(std::min(a, b));
        high.push_back(std::max(a, b));
      }
    const auto find_ends = [&](const double begin, const double end) {
      reach              = {{begin, end}};
      const double least = large_part * (end - begin);
      for (unsigned int f = 0; f < fibers.size(); ++f)
        {
          at_end[f] = {{low[f] <= begin + least, high[f] >= end - least}};
          if ((fibers[f].back() - fibers[f].front()) * along < 0.)
            std::swap(at_end[f][0], at_end[f][1]);
        }
    };
    const unsigned int quarter = (fibers.size() - 1) / 4;
    auto               lows = low, highs = high;
    std::nth_element(lows.begin(), lows.begin() + quarter, lows.end());
    std::nth_element(highs.begin(),
                     highs.begin() + quarter,
                     highs.end(),
                     std::greater<double>());
    find_ends(lows[quarter], highs[quarter]);
    spun = std::none_of(at_end.begin(), at_end.end(), is_whole);
    if (spun)
      find_ends(*std::min_element(low.begin(), low.end()),
                *std::max_element(high.begin(), high.end()));
  }



  std::vector<unsigned int>
  YarnReach::short_fibers() const
  {
    std::vector<unsigned int> result;
    if (!spun)
      for (unsigned int f = 0; f < at_end.size(); ++f)
        if (!is_whole(at_end[f]))
          result.push_back(f);
    return result;
  }
} // namespace Heddle
