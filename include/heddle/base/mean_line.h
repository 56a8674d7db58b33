#ifndef heddle_base_mean_line_h
#define heddle_base_mean_line_h

#include <heddle/base/polyline.h>

#include <vector>

namespace Heddle
{
  /** A plane that cuts a yarn. */
  struct CuttingPlane
  {
    Tensor<1, 3> point;

    /** Unit normal, along the yarn. */
    Tensor<1, 3> normal;
  };



  /** A fiber axis as it passes through a plane. */
  struct Passage
  {
    bool         found = false;
    Tensor<1, 3> point;
    double       cosine = 1.; /**< between fiber and normal */
  };



  /**
   * Where @p fiber passes through @p plane; if it does several times, the
   * passage nearest to the plane's point.
   */
  Passage
  pass_through(const Polyline &fiber, const CuttingPlane &plane);



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
} // namespace Heddle

#endif
