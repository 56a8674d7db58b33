#ifndef heddle_contact_angle_where_close_h
#define heddle_contact_angle_where_close_h

#include <heddle/contact/broad_phase.h>

#include <vector>

namespace Heddle
{
  namespace Contact
  {
    /**
     * Cosine of the angle of two curves in a proximity zone where they are
     * closest, and where they are about as close in several places the mean
     * over these. @p pairs are candidates of these curves, @p squared_distances
     * those of the middles of their intervals [mm^2], @p zones the number of
     * the zone that each belongs to, and @p closest the closest one of its
     * zone.
     */
    double
    cosine_where_close(const CandidatePair             *pairs,
                       const std::vector<double>       &squared_distances,
                       const std::vector<unsigned int> &zones,
                       const unsigned int               closest,
                       const Curve                     &a,
                       const Curve                     &b);
  } // namespace Contact
} // namespace Heddle

#endif
