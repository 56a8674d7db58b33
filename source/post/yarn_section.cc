#include <heddle/base/convex_hull.h>
#include <heddle/post/yarn_section.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Heddle
{
  namespace Post
  {
    namespace
    {
      /** Polygons of equal area stand for circles: a hull is then exact to 1e-3
       * of a fiber's section. */
      constexpr unsigned int n_corners = 64;
      constexpr double       one_turn  = 2. * numbers::PI / n_corners;



      std::array<Tensor<1, 2>, n_corners>
      directions_of_corners()
      {
        std::array<Tensor<1, 2>, n_corners> directions;
        for (unsigned int k = 0; k < n_corners; ++k)
          {
            directions[k][0] = std::cos(k * one_turn);
            directions[k][1] = std::sin(k * one_turn);
          }
        return directions;
      }



      /**
       * The corners of all circles, but for most of those that cannot be on the
       * hull: corner k is only there if it is furthest out in a direction that
       * is off by no more than half the angle between two corners.
       */
      std::vector<Point<2>>
      outer_corners(const std::vector<Point<2>> &centers,
                    const std::vector<double>   &radii)
      {
        static const auto   directions = directions_of_corners();
        static const double stretch = std::sqrt(one_turn / std::sin(one_turn));
        static const double off     = 1.01 * std::sin(0.5 * one_turn);

        std::vector<Point<2>> corners;
        std::vector<double>   reach(radii.size());
        for (const Tensor<1, 2> &direction : directions)
          {
            for (unsigned int i = 0; i < radii.size(); ++i)
              reach[i] = centers[i] * direction + stretch * radii[i];
            const unsigned int furthest =
              std::max_element(reach.begin(), reach.end()) - reach.begin();
            for (unsigned int i = 0; i < radii.size(); ++i)
              if (reach[furthest] - reach[i] <=
                  off * (centers[furthest].distance(centers[i]) +
                         std::abs(radii[furthest] - radii[i])))
                corners.push_back(centers[i] + stretch * radii[i] * direction);
          }
        return corners;
      }



      /** Extent and hull of circles about the points of @p section. */
      void
      measure(YarnCut &section, const std::vector<double> &radii)
      {
        double left = 1e300, right = -1e300;
        double bottom = 1e300, top = -1e300;
        for (unsigned int i = 0; i < radii.size(); ++i)
          {
            const Point<2> &p = section.points[i];
            left              = std::min(left, p[0] - radii[i]);
            right             = std::max(right, p[0] + radii[i]);
            bottom            = std::min(bottom, p[1] - radii[i]);
            top               = std::max(top, p[1] + radii[i]);
          }
        section.width  = right - left;
        section.height = top - bottom;
        section.hull_area =
          polygon_area(convex_hull(outer_corners(section.points, radii)));
      }
    } // namespace



    YarnCut
    cut_yarn(const std::vector<Polyline> &fibers,
             const std::vector<double>   &radii,
             const CuttingPlane          &plane)
    {
      AssertDimension(fibers.size(), radii.size());

      // Of a yarn that runs through the thickness y takes the place of z.
      Tensor<1, 3> vertical;
      vertical[is_steep(plane.normal) ? 1 : 2] = 1.;
      Tensor<1, 3> across = cross_product_3d(vertical, plane.normal);
      across /= across.norm();
      const Tensor<1, 3> up = cross_product_3d(plane.normal, across);

      YarnCut             section;
      std::vector<double> radii_found;
      for (unsigned int f = 0; f < fibers.size(); ++f)
        {
          const Passage passage = pass_through(fibers[f], plane);
          if (!passage.found)
            {
              ++section.n_missing;
              continue;
            }
          const Tensor<1, 3> place = passage.point - plane.point;
          section.points.emplace_back(place * across, place * up);
          section.centroid += Tensor<1, 2>({place * across, place * up});
          section.center += passage.point;
          section.fiber_area += numbers::PI * radii[f] * radii[f] /
                                (passage.direction * plane.normal);
          radii_found.push_back(radii[f]);
        }
      if (section.points.empty())
        return section;
      section.centroid /= section.points.size();
      section.center /= section.points.size();
      measure(section, radii_found);
      return section;
    }
  } // namespace Post
} // namespace Heddle
