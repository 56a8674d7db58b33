#ifndef heddle_post_crossing_order_h
#define heddle_post_crossing_order_h

#include <heddle/base/polyline.h>
#include <heddle/system/state.h>

#include <optional>
#include <string>
#include <utility>
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



    /**
     * The points of two lines at which their projections on the xy-plane
     * intersect, the first of them along the first line; nothing if they do
     * not.
     */
    std::optional<std::pair<Tensor<1, 3>, Tensor<1, 3>>>
    crossing_points(const Polyline &first, const Polyline &second);



    /** Pairs of fibers at one or many crossings. */
    struct CrossingCount
    {
      /** Pairs of an upper and a lower fiber. */
      unsigned int total = 0;

      /** Pairs whose upper fiber is not above where they cross. */
      unsigned int wrong = 0;

      /** Pairs whose projections on the plane of the fabric do not cross. */
      unsigned int apart = 0;

      /** "3 of 36 crossings of fibers are not as the pattern wants them", or
       * nothing if all of them are. */
      std::string
      wrong_in_words() const;

      /**
       * "3 of 36 pairs of fibers do not cross though the pattern wants it",
       * such as fibers that have slipped off the ends of others, or nothing.
       */
      std::string
      apart_in_words() const;
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

    /**
     * The same of the centerlines of all ranks: each compares its own fibers
     * with those that one rank after another shows to all. Of a fabric that is
     * bent @p flattened tells where points are if it is flat again.
     * @note Collective.
     */
    CrossingCount
    count_crossing_order(const System::State              &state,
                         const std::vector<OrderedFibers> &crossings,
                         const PointMap                   &flattened = {});
  } // namespace Post
} // namespace Heddle

#endif
