#include <heddle/base/mean_line.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace Heddle
{
  namespace
  {
    /** Of a yarn's length, that a fiber should not lack at an end [-]. */
    constexpr double large_part = 0.1;

    /** From end to end of a yarn that has two ends, over its length [-]. */
    constexpr double least_way = 0.5;



    /** Lengths along @p line up to each of its points. */
    std::vector<double>
    lengths_along(const Polyline &line)
    {
      std::vector<double> lengths(1, 0.);
      for (unsigned int i = 1; i < line.size(); ++i)
        lengths.push_back(lengths.back() + (line[i] - line[i - 1]).norm());
      return lengths;
    }



    /** Number of the segment of @p lengths in which @p length lies. */
    unsigned int
    segment_at(const std::vector<double> &lengths, const double length)
    {
      return std::clamp<std::ptrdiff_t>(
        std::lower_bound(lengths.begin(), lengths.end(), length) -
          lengths.begin() - 1,
        0,
        lengths.size() - 2);
    }



    Tensor<1, 3>
    point_at(const Polyline            &line,
             const std::vector<double> &lengths,
             const double               length)
    {
      const unsigned int s = segment_at(lengths, length);
      return line[s] + (length - lengths[s]) / (lengths[s + 1] - lengths[s]) *
                         (line[s + 1] - line[s]);
    }
  } // namespace



  Passage
  pass_through(const Polyline &fiber, const CuttingPlane &plane)
  {
    Passage passage;
    double  nearest = std::numeric_limits<double>::max();
    for (unsigned int s = 0; s + 1 < fiber.size(); ++s)
      {
        const double before = (fiber[s] - plane.point) * plane.normal;
        const double after  = (fiber[s + 1] - plane.point) * plane.normal;
        if (before * after > 0. || before == after)
          continue;
        const Tensor<1, 3> chord = fiber[s + 1] - fiber[s];
        const Tensor<1, 3> point = fiber[s] + before / (before - after) * chord;
        if ((point - plane.point).norm() < nearest)
          {
            nearest        = (point - plane.point).norm();
            passage.found  = true;
            passage.point  = point;
            passage.cosine = std::abs(chord * plane.normal) / chord.norm();
          }
      }
    return passage;
  }



  Polyline
  mean_line(const std::vector<Polyline> &fibers, const unsigned int n_points)
  {
    const double       weight = 1. / fibers.size();
    Polyline           mean(n_points);
    const Tensor<1, 3> direction = fibers[0].back() - fibers[0].front();
    for (const Polyline &fiber : fibers)
      {
        const bool backward = (fiber.back() - fiber.front()) * direction < 0.;
        const std::vector<double> lengths = lengths_along(fiber);
        for (unsigned int k = 0; k < n_points; ++k)
          {
            const unsigned int i = backward ? n_points - 1 - k : k;
            mean[k] +=
              weight *
              point_at(fiber, lengths, lengths.back() * i / (n_points - 1));
          }
      }
    return mean;
  }



  std::vector<unsigned int>
  short_fibers(const std::vector<Polyline> &fibers)
  {
    Tensor<1, 3> span;
    double       longest = 0.;
    for (const Polyline &fiber : fibers)
      {
        const Tensor<1, 3> own = fiber.back() - fiber.front();
        span += own * span < 0. ? -own : own;
        longest = std::max(longest, lengths_along(fiber).back());
      }
    const double norm = span.norm();
    if (norm < least_way * longest * fibers.size())
      return {};
    std::vector<double> low, high;
    for (const Polyline &fiber : fibers)
      {
        const double a = fiber.front() * span / norm;
        const double b = fiber.back() * span / norm;
        low.push_back(std::min(a, b));
        high.push_back(std::max(a, b));
      }
    const unsigned int quarter = (fibers.size() - 1) / 4;
    auto               lows = low, highs = high;
    std::nth_element(lows.begin(), lows.begin() + quarter, lows.end());
    std::nth_element(highs.begin(),
                     highs.begin() + quarter,
                     highs.end(),
                     std::greater<double>());
    const double begin = lows[quarter], end = highs[quarter];

    std::vector<unsigned int> result;
    for (unsigned int f = 0; f < fibers.size(); ++f)
      if (low[f] > begin + large_part * (end - begin) ||
          high[f] < end - large_part * (end - begin))
        result.push_back(f);

    // Where none runs from end to end, as in a spun yarn, all are as good.
    if (result.size() == fibers.size())
      return {};
    return result;
  }



  CuttingPlane
  plane_at(const Polyline &mean_line, const double fraction)
  {
    const std::vector<double> lengths = lengths_along(mean_line);
    const double              length  = fraction * lengths.back();
    const unsigned int        s       = segment_at(lengths, length);
    const Tensor<1, 3>        chord   = mean_line[s + 1] - mean_line[s];
    return {point_at(mean_line, lengths, length), chord / chord.norm()};
  }



  bool
  is_steep(const Tensor<1, 3> &direction)
  {
    return std::abs(direction[2]) > 0.9 * direction.norm();
  }



  double
  crimp(const Polyline &mean_line)
  {
    Tensor<1, 3> span = mean_line.back() - mean_line.front();
    if (!is_steep(span))
      span[2] = 0.;
    return lengths_along(mean_line).back() / span.norm() - 1.;
  }
} // namespace Heddle
