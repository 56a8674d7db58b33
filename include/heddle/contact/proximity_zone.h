#ifndef heddle_contact_proximity_zone_h
#define heddle_contact_proximity_zone_h

#include <heddle/contact/broad_phase.h>

#include <functional>
#include <utility>
#include <vector>

namespace Heddle
{
  namespace Contact
  {
    /**
     * Two parts of two fibers (or of one, apart along it) that are close all
     * along: a connected set of pairs of intervals.
     */
    struct ProximityZone
    {
      unsigned int fiber_a, fiber_b;
      int          orientation; /**< +1: the fibers run the same way, else -1 */

      /** Places at which the zone was sampled: p, q and squared distance. */
      struct Sample
      {
        double p, q;             /**< [mm] */
        double squared_distance; /**< [mm^2] */
      };
      std::vector<Sample> samples; /**< sorted by p */

      /** Range of p that its intervals cover [mm]. */
      double begin, end;

      /** Mean sine of the angle of the fibers where they are close. */
      double sine;

      /**
       * Cosine of their angle where they are closest, in this orientation:
       * below 0 if the fibers have kept it beyond a right angle.
       */
      double cosine;

      /** A guess of q at @p p, from the closest pair of intervals there. */
      double
      guess(const double p) const;

      /** Arc lengths on both fibers where the samples are closest [mm]. */
      std::pair<double, double>
      closest() const;
    };

    /** The orientation that particles at these arc lengths had so far, or 0. */
    using KnownOrientation = std::function<int(double s_a, double s_b)>;

    /**
     * Group the candidates @p first to @p last, all of one pair of fibers, into
     * zones. Near a right angle, where both orientations are as good, @p known
     * decides, lest forces jump to and fro between searches.
     */
    std::vector<ProximityZone>
    find_zones(
      const CandidatePair    *first,
      const CandidatePair    *last,
      const Curve            &a,
      const Curve            &b,
      const KnownOrientation &known = [](double, double) { return 0; });
  } // namespace Contact
} // namespace Heddle

#endif
