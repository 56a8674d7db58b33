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
    Tensor<1, 3> direction; /**< of the fiber, to the normal's side [-] */
  };



  /**
   * Where @p fiber passes through @p plane; if it does several times, the
   * passage nearest to the plane's point.
   */
  Passage
  pass_through(const Polyline &fiber, const CuttingPlane &plane);



  /**
   * Mean line of a yarn [mm]. It runs as the first fiber does.
   *
   * Of fibers that run from end to end (YarnReach) it is the mean at each of
   * @p n_points equal fractions of their lengths; those that run against the
   * first one are taken from their other ends, and those that end before the
   * yarn does have no place along it that is known. Where none runs from end to
   * end, in a yarn that is spun of staple fibers, the line has their mean
   * direction in planes across the yarn, and lies in their midst in the mean
   * over its length: the mean of those that are there would jump wherever one
   * ends. It has so many more points as it is longer than they are.
   */
  Polyline
  mean_line(const std::vector<Polyline> &fibers, const unsigned int n_points);

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
