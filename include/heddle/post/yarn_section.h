#ifndef heddle_post_yarn_section_h
#define heddle_post_yarn_section_h

#include <heddle/base/mean_line.h>
#include <heddle/base/polyline.h>

#include <deal.II/base/point.h>

#include <vector>

namespace Heddle
{
  namespace Post
  {
    using namespace dealii;

    /**
     * What a plane shows of a yarn. Coordinates in the plane: the first axis
     * lies in the plane of the fabric, the second one points up; where the yarn
     * is steep (is_steep()) they lie along x and y.
     */
    struct YarnCut
    {
      /** Where the fiber axes pass, one point per fiber that does [mm]. */
      std::vector<Point<2>> points;

      /** Fibers of the yarn that do not reach the plane. */
      unsigned int n_missing = 0;

      /** Mean of the points [mm]; its place in space is @p center. */
      Point<2>     centroid;
      Tensor<1, 3> center;

      /** Extent of the fibers, radius included [mm]. */
      double width  = 0.;
      double height = 0.;

      /** Of the fiber sections as the plane cuts them: ellipses [mm^2]. */
      double fiber_area = 0.;

      /** Of the convex hull of the fibers, radius included [mm^2]. */
      double hull_area = 0.;

      /** Fiber area over hull area [-]. */
      double
      volume_fraction() const
      {
        return hull_area > 0. ? fiber_area / hull_area : 0.;
      }

      /** Width over height [-]. */
      double
      aspect_ratio() const
      {
        return height > 0. ? width / height : 0.;
      }
    };



    /**
     * Cut the fibers of one yarn by a plane. A fiber that passes several times
     * is taken where it is nearest to the plane's point.
     *
     * @p radii holds the radius of each fiber [mm]; the hull takes every fiber
     * as the ellipse's inscribed circle of that radius.
     */
    YarnCut
    cut_yarn(const std::vector<Polyline> &fibers,
             const std::vector<double>   &radii,
             const CuttingPlane          &plane);
  } // namespace Post
} // namespace Heddle

#endif
