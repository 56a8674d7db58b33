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
   * lengths, the mean of its fibers [mm]. It runs as the first one does; those
   * that run against it are taken from their other ends.
   */
  Polyline
  mean_line(const std::vector<Polyline> &fibers, const unsigned int n_points);

  /**
   * Numbers of the fibers of a yarn that end before the yarn does, by more than
   * a tenth of its length, such as those that were lost while they were traced.
   * A yarn reaches as far as a quarter of its fibers do. One that ends near
   * where it begins has none.
   */
  std::vector<unsigned int>
  short_fibers(const std::vector<Polyline> &fibers);

  /**
   * The plane normal to the mean line at @p fraction of its length, 0 to 1.
   */
  CuttingPlane
  plane_at(const Polyline &mean_line, const double fraction);

  /**
   * Whether a yarn in this direction runs through the thickness of a fabric,
   * within 26 degrees of z, and not along its plane.
   */
  bool
  is_steep(const Tensor<1, 3> &direction);

  /**
   * Crimp: by how much a line is longer than the way from its first to its last
   * point in the plane of the fabric or, if that is steep, in space [-].
   */
  double
  crimp(const Polyline &mean_line);
} // namespace Heddle

#endif
