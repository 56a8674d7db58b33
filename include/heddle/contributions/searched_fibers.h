#ifndef heddle_contributions_searched_fibers_h
#define heddle_contributions_searched_fibers_h

#include <heddle/contact/curve_list.h>
#include <heddle/contributions/centerlines.h>
#include <heddle/system/contribution.h>

#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /**
     * The fibers among which contact is searched: where they are, and how far
     * each has moved since it was last searched. One that has moved so far that
     * a pair outside the search distance could have come close is stale, and is
     * to be searched anew.
     *
     * With each search the state gets those pieces of foreign fibers for its
     * ghosts that are near the own ones.
     */
    class SearchedFibers
    {
    public:
      /**
       * Surfaces within @p search_distance times @p largest_radius [mm] are
       * searched.
       */
      SearchedFibers(const System::FiberSpace &space,
                     const double              largest_radius,
                     const double              search_distance);

      /** The fibers are where @p state has them. */
      void
      set(const System::State &state);

      /** Find how far each fiber that is held here has moved. */
      void
      measure_motion(const System::State &state);

      /** The next search is one of all fibers. */
      void
      forget_search()
      {
        searched = false;
      }

      /**
       * Measure the motion, on all ranks alike, and return whether a fiber is
       * stale.
       * @note Collective.
       */
      bool
      needs_search(const System::State &state);

      /**
       * Mark the curves of stale fibers, and count their motion from now on.
       * Return whether the state got other ghosts: then all are stale, for
       * knots have other numbers.
       * @note Collective.
       */
      bool
      begin_search(System::State &state);

      /** The centerlines, as long as none are set anew. */
      const Contact::CurveList &
      curves() const
      {
        return all_curves;
      }

      /**
       * By fiber, as last measured: no point of its axis has moved further
       * [mm].
       */
      const std::vector<double> &
      moved() const
      {
        return moved_by;
      }

      /**
       * The largest factor by which the step @p increment may be taken without
       * that fibers meet unseen or that two axes pass through each other, where
       * @p thickness [mm] is for each fiber the least sum of radii with those
       * that are watched beside it. Local.
       */
      double
      searched_step(const System::State       &state,
                    const System::Increment   &increment,
                    const std::vector<double> &thickness) const;

      /** Whether this rank has all fibers. */
      bool
      hold_all() const;

      /**
       * The same where nothing is watched: as far as that is still so on the
       * way, by how far all fibers are apart. For a rank that holds them all.
       */
      double
      clear_step(const System::State     &state,
                 const System::Increment &increment) const;

    private:
      /** The change of a centerline along a step. */
      struct Motion
      {
        std::vector<Tensor<1, 3>> positions, tangents; /**< of knots */
        double                    furthest = 0.; /**< of its surface [mm] */
      };

      /** Set @p motion to that of the owned fiber @p f. */
      void
      find_motion(const unsigned int       f,
                  const System::State     &state,
                  const System::Increment &increment,
                  Motion                  &motion) const;

      /** Return whether there are others now. */
      bool
      fetch_near_fibers(System::State &state);

      const System::FiberSpace &space;
      const double              largest_radius;  /**< [mm] */
      const double              search_distance; /**< over the radius [-] */
      const double              stale_motion;    /**< [mm] */

      Centerlines               centerlines;
      Contact::CurveList        all_curves;
      bool                      searched = false;
      std::vector<Tensor<1, 3>> searched_at; /**< of knots: position, tangent */
      std::vector<double>       moved_by;
    };
  } // namespace Contributions
} // namespace Heddle

#endif
