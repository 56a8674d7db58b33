#ifndef heddle_contact_contact_cells_h
#define heddle_contact_contact_cells_h

#include <heddle/contact/contact_cell.h>
#include <heddle/contact/curve_list.h>
#include <heddle/contact/normal_law.h>
#include <heddle/contact/old_cells.h>
#include <heddle/contact/proximity_zone.h>

#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace Heddle
{
  namespace Contact
  {
    /**
     * The discretisation of all intermediate geometries: proximity zones, the
     * cells that cover them, and the penalty of each cell. It outlives the
     * configuration: elements are placed anew in the same cells, and a new
     * search hands the penalties on.
     */
    class ContactCells
    {
    public:
      /** Says whether two fibers can touch at all. */
      using Filter = std::function<bool(unsigned int, unsigned int)>;

      /** Penalty to begin with, of two fibers [N/mm^2]. */
      using FirstPenalty = std::function<double(unsigned int, unsigned int)>;

      /** A zone as elements were last placed in it. */
      struct Zone
      {
        double penetration; /**< the deepest, 0 if the fibers are apart [mm] */
        double radius;      /**< the smaller one [mm] */
      };

      /**
       * Watch surfaces closer than @p search_distance [mm]. A cell is as long
       * as an interval between nodes over @p refinement.
       */
      ContactCells(const double        search_distance,
                   const double        refinement,
                   const FirstPenalty &first_penalty);

      /**
       * Find zones and cover them with cells, for all pairs of which a curve is
       * stale; others keep theirs. No point of the axis of fiber f has @p moved
       * further than moved[f] since it was last stale [mm].
       */
      void
      search(const CurveList           &curves,
             const std::vector<double> &moved,
             const Filter              &filter);

      /**
       * Append the elements of all cells to @p elements, with forces by the law
       * that becomes linear at half of @p threshold times the radius, on
       * surfaces that wear a skin of @p skin times the radius. With @p moved as
       * in search(), cells that are too far from contact are passed over.
       */
      void
      place_elements(const CurveList             &curves,
                     const std::vector<double>   &moved,
                     const double                 threshold,
                     const double                 skin,
                     std::vector<ContactElement> &elements);

      /**
       * The pairs of fiber intervals that may come to touch until surfaces have
       * approached each other by @p approach [mm] since the search, sorted.
       */
      std::vector<CandidatePair>
      near_pairs(const CurveList &curves, const double approach) const;

      /**
       * Raise the penalties of the zones whose deepest penetration exceeds
       * @p threshold times the radius, or nearly does, as far as that may be
       * of use; return whether any was.
       */
      bool
      adapt(const double threshold);

      /** Whether its penalty is as large as any gets. */
      bool
      is_stiffest(const ContactCell &cell) const;

      const std::vector<Zone> &
      zones() const
      {
        return all_zones;
      }

      const std::vector<ContactCell> &
      cells() const
      {
        return all_cells;
      }

      /** Law of a zone at this threshold and skin, both over the radius. */
      NormalLaw
      law(const unsigned int zone,
          const double       threshold,
          const double       skin) const
      {
        const double radius = all_zones[zone].radius;
        return {0.5 * threshold * radius, skin * radius};
      }

      /** From now on cells harden from the penalties that they have. */
      void
      accept();

      /** By the numbers of two fibers, the smaller one first [mm]. */
      using ForgivenPenetrations =
        std::map<std::pair<unsigned int, unsigned int>, double>;

      /**
       * What fibers lie in each other now counts as none from now on: where
       * they met in any place, the sum of their radii is taken smaller by the
       * deepest penetration, all along. So nothing touches as elements were
       * last placed, and forces stay smooth as fibers move.
       */
      void
      forgive();

      const ForgivenPenetrations &
      forgiven_penetrations() const
      {
        return forgiven_of;
      }

      void
      set_forgiven(const ForgivenPenetrations &penetrations);

      /** Set the penalties from which the next search hands on [N/mm^2]. */
      void
      set_cells(const std::vector<ContactCell> &cells);

    private:
      IntermediateGeometry
      geometry(const CurveList &curves, const ContactCell &cell) const;

      /** Size of the whole cells of two fibers in the coordinate p [mm]. */
      double
      whole_cell(const Curve &a, const Curve &b) const;

      /** Range of p that a cell covers. */
      std::pair<double, double>
      range(const ContactCell &cell, const IntermediateGeometry &between) const;

      /** One of both ends of a cell. */
      struct Sought
      {
        unsigned int cell;
        bool         begin;
      };

      /** Where these ends of cells are, as placed in anew. */
      std::vector<CellEnd>
      find_ends(const CurveList           &curves,
                const std::vector<Sought> &sought) const;

      /** Leave the cells, and zones, of pairs of which no curve is stale. */
      void
      keep_cells(const CurveList                &curves,
                 const std::vector<ContactCell> &old_cells);

      /** The cells of this pair of fibers begin with @p first_of_pair. */
      void
      cover_zone(const CurveList           &curves,
                 const std::vector<double> &moved,
                 const ProximityZone       &zone,
                 const OldCells            &old_cells,
                 const std::size_t          first_of_pair);

      /**
       * Whether the cell is there already, among those of other zones of the
       * pair, from @p first_of_pair to @p first_of_zone.
       */
      bool
      is_covered(const ContactCell &cell,
                 const double       size,
                 const std::size_t  first_of_pair,
                 const std::size_t  first_of_zone) const;

      double
      forgiven_for(const ContactCell &cell) const;

      const double             search_distance;
      const double             refinement;
      const FirstPenalty       first_penalty;
      std::vector<Zone>        all_zones;
      std::vector<ContactCell> all_cells;
      ForgivenPenetrations     forgiven_of;
    };
  } // namespace Contact
} // namespace Heddle

#endif
