#ifndef heddle_contact_candidate_pair_h
#define heddle_contact_candidate_pair_h

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <vector>

namespace Heddle
{
  namespace Contact
  {
    /** Interval number @p interval_a of a fiber a close to one of b. */
    struct CandidatePair
    {
      unsigned int fiber_a, fiber_b; /**< a <= b */
      unsigned int interval_a, interval_b;
    };

    inline bool
    operator<(const CandidatePair &left, const CandidatePair &right)
    {
      const auto key = [](const unsigned int high, const unsigned int low) {
        return std::uint64_t(high) << 32 | low;
      };
      const std::uint64_t fibers       = key(left.fiber_a, left.fiber_b),
                          other_fibers = key(right.fiber_a, right.fiber_b);
      return (fibers < other_fibers) |
             ((fibers == other_fibers) &
              (key(left.interval_a, left.interval_b) <
               key(right.interval_a, right.interval_b)));
    }

    inline bool
    operator==(const CandidatePair &left, const CandidatePair &right)
    {
      return !(left < right) && !(right < left);
    }

    /** Sort @p pairs, and keep each of them once. */
    inline void
    sort_and_unify(std::vector<CandidatePair> &pairs)
    {
      // Nearly all pairs that stand twice follow each other.
      pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
      std::sort(pairs.begin(), pairs.end());
      pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    }

    /** The union of two sorted lists, each pair once. */
    inline std::vector<CandidatePair>
    union_of(const std::vector<CandidatePair> &first,
             const std::vector<CandidatePair> &second)
    {
      std::vector<CandidatePair> all;
      std::set_union(first.begin(),
                     first.end(),
                     second.begin(),
                     second.end(),
                     std::back_inserter(all));
      return all;
    }

    /**
     * Add @p pairs to @p known, both sorted. Contacts come and go, and pairs
     * that touched before may touch again; but where the most part of what is
     * known is gone, it is forgotten.
     */
    inline void
    extend_pairs(std::vector<CandidatePair>       &known,
                 const std::vector<CandidatePair> &pairs)
    {
      if (known.size() > 2 * pairs.size())
        known.clear();
      known = union_of(known, pairs);
    }
  } // namespace Contact
} // namespace Heddle

#endif
