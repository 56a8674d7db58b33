#include <heddle/base/convex_hull.h>
#include <heddle/base/normals.h>
#include <heddle/base/yarn_reach.h>
#include <heddle/textile/extent.h>
#include <heddle/textile/yarn_body.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      /** Distance from @p point to the segment from @p a to @p b. */
      double
      distance_to_edge(const Point<2> &point,
                       const Point<2> &a,
                       const Point<2> &b)
      {
        const Tensor<1, 2> edge   = b - a;
        const double       square = edge.norm_square();
        const double       t =
          square > 0. ? std::clamp((point - a) * edge / square, 0., 1.) : 0.;
        return (point - (a + t * edge)).norm();
      }



      /**
       * Signed distance to the boundary of a convex polygon, positive inside.
       * A polygon of one or two corners has no inside.
       */
      double
      depth_in_polygon(const Point<2>              &point,
                       const std::vector<Point<2>> &corners)
      {
        double distance = std::numeric_limits<double>::max();
        bool   inside   = corners.size() > 2;
        for (unsigned int i = 0; i < corners.size(); ++i)
          {
            const Point<2>    &a    = corners[i];
            const Point<2>    &b    = corners[(i + 1) % corners.size()];
            const Tensor<1, 2> edge = b - a, arm = point - a;
            distance = std::min(distance, distance_to_edge(point, a, b));
            inside   = inside && edge[0] * arm[1] - edge[1] * arm[0] >= 0.;
          }
        return inside ? distance : -distance;
      }



      /** Unit vector along @p line, out of its first or last point. */
      Tensor<1, 3>
      way_out(const Polyline &line, const unsigned int end)
      {
        const Tensor<1, 3> chord =
          end == 0 ? line[0] - line[1] : line.back() - line[line.size() - 2];
        return chord / chord.norm();
      }



      /** Let @p line go straight on by @p length at its first or last point. */
      void
      lengthen(Polyline &line, const unsigned int end, const double length)
      {
        if (length <= 0.)
          return;
        const Tensor<1, 3> step = length * way_out(line, end);
        if (end == 0)
          line.insert(line.begin(), line.front() + step);
        else
          line.push_back(line.back() + step);
      }
    } // namespace



    YarnBody::YarnBody(const std::vector<FiberAxis> &fibers)
    {
      std::vector<Polyline> lines;
      unsigned int          n_points = 2;
      for (const FiberAxis &fiber : fibers)
        {
          lines.push_back(fiber.points);
          radius += fiber.radius / fibers.size();
          n_points = std::max<unsigned int>(n_points, fiber.points.size());
        }
      lines         = run_one_way(lines);
      Polyline mean = mean_line(lines, n_points);
      ends          = {{mean.front(), mean.back()}};
      extend(lines, mean);

      double length = 0.;
      for (unsigned int i = 1; i < mean.size(); ++i)
        length += (mean[i] - mean[i - 1]).norm();
      const unsigned int n_steps = std::ceil(length / radius);
      for (unsigned int i = 0; i <= n_steps; ++i)
        add_section(lines, plane_at(mean, double(i) / n_steps));
      mean_height /= sections.size();

      std::vector<Point<3>> points;
      for (const Polyline &line : lines)
        for (const Tensor<1, 3> &point : line)
          points.emplace_back(point);
      bounding_box = BoundingBox<3>(points);
      bounding_box.extend(radius);
    }



    void
    YarnBody::extend(std::vector<Polyline> &lines, Polyline &mean) const
    {
      const YarnReach yarn(lines);
      for (unsigned int end = 0; end < 2; ++end)
        {
          const Tensor<1, 3>      out = way_out(mean, end);
          std::vector<Polyline *> reaching;
          for (unsigned int f = 0; f < lines.size(); ++f)
            if (yarn.ends_with_yarn(f)[end])
              reaching.push_back(&lines[f]);
          Extent extent;
          extent.add(0.);
          for (const Polyline *line : reaching)
            extent.add(((end == 0 ? line->front() : line->back()) - ends[end]) *
                       out);
          const double reach = extent.high + radius;
          lengthen(mean, end, reach);
          // Twice the way, since a fiber may be inclined to the mean line.
          for (Polyline *line : reaching)
            lengthen(*line, end, 2. * (reach - extent.low));
        }
    }



    void
    YarnBody::add_section(const std::vector<Polyline> &lines,
                          const CuttingPlane          &plane)
    {
      const std::array<Tensor<1, 3>, 2> axes = two_normals(plane.normal);
      std::vector<Point<2>>             points;
      Extent                            heights;
      for (const Polyline &line : lines)
        {
          const Passage passage = pass_through(line, plane);
          if (!passage.found)
            continue;
          const Tensor<1, 3> place = passage.point - plane.point;
          points.emplace_back(place * axes[0], place * axes[1]);
          heights.add(passage.point[2]);
        }
      if (points.empty())
        return;
      mean_height += heights.high - heights.low + 2. * radius;

      std::vector<Point<2>> hull = convex_hull(points);
      if (hull.empty())
        hull.push_back(points[0]);
      sections.push_back({plane, axes, hull});
    }



    const YarnBody::Section &
    YarnBody::nearest_section(const Tensor<1, 3> &point) const
    {
      return *std::min_element(sections.begin(),
                               sections.end(),
                               [&point](const Section &a, const Section &b) {
                                 return (a.plane.point - point).norm_square() <
                                        (b.plane.point - point).norm_square();
                               });
    }



    double
    YarnBody::depth(const Tensor<1, 3> &point) const
    {
      const Section     &section = nearest_section(point);
      const Tensor<1, 3> place   = point - section.plane.point;
      const double       inside =
        radius + depth_in_polygon(
                   Point<2>(place * section.axes[0], place * section.axes[1]),
                   section.hull);

      const double along  = place * section.plane.normal;
      const double beyond = &section == &sections.front()  ? -along
                            : &section == &sections.back() ? along
                                                           : 0.;
      return beyond > 0. ? -std::hypot(beyond, std::max(0., -inside)) : inside;
    }



    std::vector<YarnBody>
    yarn_bodies(const std::vector<FiberAxis> &fibers)
    {
      std::map<unsigned int, std::vector<FiberAxis>> yarns;
      for (const FiberAxis &fiber : fibers)
        if (fiber.yarn_id != no_id)
          yarns[fiber.yarn_id].push_back(fiber);
      std::vector<YarnBody> bodies;
      for (const auto &yarn : yarns)
        bodies.emplace_back(yarn.second);
      return bodies;
    }
  } // namespace Textile
} // namespace Heddle
