#ifndef heddle_contact_broad_phase_h
#define heddle_contact_broad_phase_h

#include <heddle/contact/candidate_pair.h>
#include <heddle/contact/curve.h>

#include <vector>

namespace Heddle
{
  namespace Contact
  {
    /** A curve and the number of its fiber. */
    struct NumberedCurve
    {
      unsigned int fiber;
      bool         own; /**< pairs of two foreign curves are not searched */
      Curve        curve;
      bool         stale = true; /**< nor are those of two that are not stale */
    };

    /**
     * Arc length within which a fiber cannot touch itself: bent around a circle
     * of its own radius it needs half a turn to come back.
     */
    double
    least_self_separation(const Curve &curve);

    /**
     * Return all pairs of intervals whose surfaces may be closer than
     * @p search_distance [mm], sorted, each once; @p curves are sorted by their
     * fibers. None is missed: the control points of a cubic bound it, and how
     * far it is from its chords.
     */
    std::vector<CandidatePair>
    find_candidates(const std::vector<NumberedCurve> &curves,
                    const double                      search_distance);

    /**
     * Whether no surfaces are closer than @p distance [mm]: neither those of
     * two of the @p curves, nor that of one with itself where more than @p
     * window of its arc is between [mm]. All are looked at, stale or not.
     */
    bool
    are_apart(const std::vector<NumberedCurve> &curves,
              const double                      distance,
              const double                      window);
  } // namespace Contact
} // namespace Heddle

#endif
