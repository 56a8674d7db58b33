#include <heddle/base/mean_line.h>
#include <heddle/base/yarn_reach.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Heddle
{
  namespace
  {
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
            nearest       = (point - plane.point).norm();
            passage.found = true;
            passage.point = point;
            passage.direction =
              (after > before ? 1. : -1.) / chord.norm() * chord;
          }
      }
    return passage;
  }



  namespace
  {
    /** The mean of fibers that run from end to end of their yarn. */
    Polyline
    mean_of_whole(const std::vector<Polyline> &fibers,
                  const unsigned int           n_points)
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



    /** A line along a yarn of which no fiber runs from end to end. */
    Polyline
    line_of_spun(const std::vector<Polyline> &fibers,
                 const YarnReach             &reach,
                 const unsigned int           n_points)
    {
      const Tensor<1, 3> &along   = reach.direction();
      double              longest = 0.;
      Tensor<1, 3>        start;
      for (const Polyline &fiber : fibers)
        {
          longest =
            std::max(longest, std::abs((fiber.back() - fiber.front()) * along));
          start += fiber.front() / double(fibers.size());
        }
      start += (reach.extent()[0] - start * along) * along;

      const double       length  = reach.extent()[1] - reach.extent()[0];
      const unsigned int n_steps = std::ceil(n_points * length / longest);
      const double       step    = length / n_steps;
      Polyline           line(1, start);
      Tensor<1, 3>       beside;
      unsigned int       n_passages = 0;
      for (unsigned int k = 0; k < n_steps; ++k)
        {
          const CuttingPlane plane{line.back() + 0.5 * step * along, along};
          Tensor<1, 3>       sum, places;
          unsigned int       n_here = 0;
          for (const Polyline &fiber : fibers)
            {
              const Passage passage = pass_through(fiber, plane);
              if (!passage.found)
                continue;
              sum += passage.direction;
              places += passage.point;
              ++n_here;
            }
          // Where no fiber is, the line goes straight on.
          const Tensor<1, 3> way =
            n_here == 0 ? step * along : step / (sum * along) * sum;
          beside += places - double(n_here) * (line.back() + 0.5 * way);
          n_passages += n_here;
          line.push_back(line.back() + way);
        }
      for (Tensor<1, 3> &point : line)
        point += beside / n_passages;
      return line;
    }
  } // namespace



  Polyline
  mean_line(const std::vector<Polyline> &fibers, const unsigned int n_points)
  {
    const YarnReach reach(fibers);
    if (reach.is_spun())
      return line_of_spun(fibers, reach, n_points);
    const std::vector<unsigned int> lost = reach.short_fibers();
    if (lost.empty())
      return mean_of_whole(fibers, n_points);
    std::vector<Polyline> whole;
    for (unsigned int f = 0; f < fibers.size(); ++f)
      if (!std::binary_search(lost.begin(), lost.end(), f))
        whole.push_back(fibers[f]);
    return mean_of_whole(whole, n_points);
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
