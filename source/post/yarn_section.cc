#include <heddle/base/convex_hull.h>
#include <heddle/post/yarn_section.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Heddle
{
  namespace Post
  {
    namespace
    {
      /** Extent and hull of circles about the points of @p section. */
      void
      measure(YarnCut &section, const std::vector<double> &radii)
      {
        // Polygons of equal area stand for the circles: the hull is then exact
        // to 1e-3 of a fiber's section.
        constexpr unsigned int n_corners = 64;
        const double           angle     = 2. * numbers::PI / n_corners;
        const double           stretch   = std::sqrt(angle / std::sin(angle));

        std::vector<Point<2>> corners;
        double                left = 1e300, right = -1e300;
        double                bottom = 1e300, top = -1e300;
        for (unsigned int i = 0; i < radii.size(); ++i)
          {
            const Point<2> &p = section.points[i];
            left              = std::min(left, p[0] - radii[i]);
            right             = std::max(right, p[0] + radii[i]);
            bottom            = std::min(bottom, p[1] - radii[i]);
            top               = std::max(top, p[1] + radii[i]);
            for (unsigned int k = 0; k < n_corners; ++k)
              corners.emplace_back(
                p[0] + stretch * radii[i] * std::cos(k * angle),
                p[1] + stretch * radii[i] * std::sin(k * angle));
          }
        section.width     = right - left;
        section.height    = top - bottom;
        section.hull_area = polygon_area(convex_hull(corners));
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
