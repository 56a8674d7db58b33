#ifndef heddle_post_mean_line_h
#define heddle_post_mean_line_h

#include <heddle/post/polyline.h>

#include <vector>

namespace Heddle
{
  namespace Post
  {
    /** A plane that cuts a yarn. */
    struct CuttingPlane
    {
      Tensor<1, 3> point;

      /** Unit normal, along the yarn. */
      Tensor<1, 3> normal;
    };



    /**
     * Mean line of a yarn: at each of @p n_points equal fractions of their
     * lengths, the mean of its fibers [mm].
     */
    Polyline
    mean_line(const std::vector<Polyline> &fibers, const unsigned int n_points);

    /**
     * The plane normal to the mean line at @p fraction of its length, 0 to 1.
     */
    CuttingPlane
    plane_at(const Polyline &mean_line, const double fraction);

    /**
     * Crimp: by how much a line is longer than its projection on the direction
     * from its first to its last point in the plane of the fabric [-].
     */
    double
    crimp(const Polyline &mean_line);
  } // namespace Post
} // namespace Heddle

#endif
