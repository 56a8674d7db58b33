#ifndef heddle_contributions_interval_pairs_h
#define heddle_contributions_interval_pairs_h

#include <heddle/contact/candidate_pair.h>
#include <heddle/contact/contact_element.h>
#include <heddle/system/fiber_space.h>

#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    /**
     * The pairs of fiber intervals in which the particles of @p elements lie,
     * sorted, each once: what a pattern of the tangent has to cover.
     */
    template <typename Element>
    std::vector<Contact::CandidatePair>
    interval_pairs(const System::FiberSpace   &space,
                   const std::vector<Element> &elements)
    {
      std::vector<Contact::CandidatePair> pairs;
      for (const Element &element : elements)
        pairs.push_back({element.fiber_a,
                         element.fiber_b,
                         space.interval(element.fiber_a, element.s_a),
                         space.interval(element.fiber_b, element.s_b)});
      Contact::sort_and_unify(pairs);
      return pairs;
    }

    /** Where the middles of two intervals would touch, for a pattern. */
    inline Contact::ContactElement
    contact_of_middles(const System::FiberSpace     &space,
                       const Contact::CandidatePair &pair)
    {
      Contact::ContactElement element = {};
      element.fiber_a                 = pair.fiber_a;
      element.fiber_b                 = pair.fiber_b;
      element.s_a = space.middle(pair.fiber_a, pair.interval_a);
      element.s_b = space.middle(pair.fiber_b, pair.interval_b);
      return element;
    }
  } // namespace Contributions
} // namespace Heddle

#endif
