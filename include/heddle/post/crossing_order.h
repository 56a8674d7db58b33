#ifndef heddle_post_crossing_order_h
#define heddle_post_crossing_order_h

#include <heddle/base/polyline.h>

#include <vector>

namespace Heddle
{
  namespace Post
  {
    /** Two yarns that cross: which fibers shall lie above which. */
    struct OrderedFibers
    {
      /** Numbers of the fibers of the yarn that the pattern puts on top. */
      std::vector<unsigned int> upper;

      /** Numbers of the fibers of the other yarn. */
      std::vector<unsigned int> lower;
    };



    /** Pairs of fibers at one or many crossings. */
    struct CrossingCount
    {
      /** Pairs of an upper and a lower fiber. */
      unsigned int total = 0;

      /** Pairs whose upper fiber is not above where they cross. */
      unsigned int wrong = 0;

      /** Pairs whose projections on the plane of the fabric do not cross. */
      unsigned int apart = 0;
    };



    /**
     * Count the pairs of fibers that lie against the weave pattern. Two fibers
     * are compared where their projections on the xy-plane intersect; if they
     * do so several times, one intersection in the wrong order makes the pair
     * wrong. Equal heights are wrong.
     *
     * @param fibers A polyline for each fiber; those that no crossing names may
     * be empty.
     */
    CrossingCount
    count_crossing_order(const std::vector<Polyline>      &fibers,
                         const std::vector<OrderedFibers> &crossings);
  } // namespace Post
} // namespace Heddle

#endif
