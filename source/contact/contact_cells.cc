#include <heddle/contact/contact_cells.h>

#include <algorithm>
#include <cmath>

namespace Heddle
{
  namespace Contact
  {
    namespace
    {
      /** A penalty aims below the threshold, lest it has to be raised again. */
      constexpr double safety = 0.75;

      /** When penalties are raised, zones as near to the threshold are too. */
      constexpr double near = 0.9;

      /** Largest factor by which a penalty grows at once. */
      constexpr double largest_growth = 4.;

      /** Penetrations that do not follow the penalty are taken for this power.
       */
      constexpr double least_power = 0.1;

      /**
       * Over the first penalty: where that does not keep fibers apart, as those
       * that supports hold in each other, nothing will. Fabrics need up to
       * 1e4.
       */
      constexpr double stiffest = 1e7;

      /**
       * By how much a penalty is to be raised for a penetration, in radii, to
       * come to the one that is wanted. The penetration goes like a power of
       * the penalty: the first where the force is given, hardly at all where
       * stiff neighbours prescribe how near the fibers are. Which one, tells
       * what the penalty was raised by before.
       */
      double
      growth_of_penalty(const ContactCell &cell,
                        const double       penetration,
                        const double       wanted)
      {
        const double power =
          cell.raised_by > 1.
            ? std::clamp(std::log(cell.raised_for / penetration) /
                           std::log(cell.raised_by),
                         least_power,
                         1.)
            : 1.;
        return std::min(std::pow(penetration / wanted, 1. / power),
                        largest_growth);
      }
    } // namespace



    ContactCells::ContactCells(const double        search_distance,
                               const double        refinement,
                               const FirstPenalty &first_penalty)
      : search_distance(search_distance)
      , refinement(refinement)
      , first_penalty(first_penalty)
    {
    }



    void
    ContactCells::accept()
    {
      for (ContactCell &cell : all_cells)
        cell.hardened = cell.raised_by = 1.;
    }



    void
    ContactCells::set_cells(const std::vector<ContactCell> &cells)
    {
      all_cells = cells;
      std::sort(all_cells.begin(), all_cells.end());
    }



    void
    ContactCells::forgive()
    {
      for (const ContactCell &cell : all_cells)
        {
          const double penetration = all_zones[cell.zone].penetration;
          const double round_off   = 1e-13 * all_zones[cell.zone].radius;
          if (penetration > 0.)
            {
              double &sum = forgiven_of[{cell.fiber_a, cell.fiber_b}];
              sum = std::max(sum, cell.forgiven + penetration + round_off);
            }
        }
      set_forgiven(forgiven_of);
    }



    void
    ContactCells::set_forgiven(const ForgivenPenetrations &penetrations)
    {
      forgiven_of = penetrations;
      for (ContactCell &cell : all_cells)
        cell.forgiven = forgiven_for(cell);
    }



    double
    ContactCells::forgiven_for(const ContactCell &cell) const
    {
      const auto found = forgiven_of.find({cell.fiber_a, cell.fiber_b});
      return found == forgiven_of.end() ? 0. : found->second;
    }



    IntermediateGeometry
    ContactCells::geometry(const CurveList   &curves,
                           const ContactCell &cell) const
    {
      const Curve &a = curves[cell.fiber_a];
      return IntermediateGeometry(
        a,
        curves[cell.fiber_b],
        cell.orientation,
        cell.fiber_a == cell.fiber_b ? least_self_separation(a) : 0.);
    }



    double
    ContactCells::whole_cell(const Curve &a, const Curve &b) const
    {
      // Two mean intervals, halved, doubled: p is twice an arc length.
      return (a.length() / (a.n_knots - 1) + b.length() / (b.n_knots - 1)) /
             refinement;
    }



    std::pair<double, double>
    ContactCells::range(const ContactCell          &cell,
                        const IntermediateGeometry &between) const
    {
      const double size = whole_cell(between.a, between.b) / (1u << cell.level);
      const auto   whole = between.range();
      return {std::max(cell.number * size, whole.first),
              std::min((cell.number + 1) * size, whole.second)};
    }



    std::vector<CellEnd>
    ContactCells::find_ends(const CurveList           &curves,
                            const std::vector<Sought> &sought) const
    {
      std::vector<CellEnd> ends(sought.size());
      for (std::size_t first = 0; first < sought.size();
           first += n_ends_at_once)
        {
          // The last ones are filled up with themselves.
          const auto end_at = [&](const unsigned int i) -> const Sought & {
            return sought[std::min(first + i, sought.size() - 1)];
          };
          const auto cell = [&](const unsigned int i) -> const ContactCell & {
            return all_cells[end_at(i).cell];
          };
          const std::array<IntermediateGeometry, n_ends_at_once> between = {
            {geometry(curves, cell(0)),
             geometry(curves, cell(1)),
             geometry(curves, cell(2)),
             geometry(curves, cell(3))}};
          std::array<const IntermediateGeometry *, n_ends_at_once> geometries;
          std::array<double, n_ends_at_once>                       p, q;
          for (unsigned int i = 0; i < n_ends_at_once; ++i)
            {
              geometries[i]      = &between[i];
              const auto p_range = range(cell(i), between[i]);
              p[i] = end_at(i).begin ? p_range.first : p_range.second;
              q[i] = end_at(i).begin ? cell(i).q_begin : cell(i).q_end;
            }
          const auto found = cell_ends(geometries, p, q);
          std::copy_n(
            found.begin(),
            std::min<std::size_t>(n_ends_at_once, sought.size() - first),
            ends.begin() + first);
        }
      return ends;
    }



    void
    ContactCells::place_elements(const CurveList             &curves,
                                 const std::vector<double>   &moved,
                                 const double                 threshold,
                                 const double                 skin,
                                 std::vector<ContactElement> &elements)
    {
      for (Zone &zone : all_zones)
        zone.penetration = 0.;

      std::vector<Sought> near_cells;
      for (unsigned int c = 0; c < all_cells.size(); ++c)
        {
          const ContactCell &cell = all_cells[c];
          if (cell.clearance <= skin * all_zones[cell.zone].radius +
                                  moved[cell.fiber_a] + moved[cell.fiber_b])
            near_cells.push_back({c, /*begin=*/false});
        }
      const std::vector<CellEnd> ends = find_ends(curves, near_cells);

      // Neighbouring cells share their ends, unless strongly bent fibers face
      // each other in several places.
      const auto continues = [&](const unsigned int k) {
        const unsigned int c = near_cells[k].cell;
        if (k == 0 || near_cells[k - 1].cell + 1 != c)
          return false;
        const ContactCell &cell = all_cells[c], &before = all_cells[c - 1];
        return before.zone == cell.zone && before.number + 1 == cell.number &&
               std::abs(ends[k - 1].q - cell.q_begin) <
                 curves[cell.fiber_a].radius + curves[cell.fiber_b].radius;
      };
      std::vector<Sought> first_cells;
      for (unsigned int k = 0; k < near_cells.size(); ++k)
        if (!continues(k))
          first_cells.push_back({near_cells[k].cell, /*begin=*/true});
      const std::vector<CellEnd> begins = find_ends(curves, first_cells);

      unsigned int n_begun = 0;
      for (unsigned int k = 0; k < near_cells.size(); ++k)
        {
          const unsigned int         c       = near_cells[k].cell;
          const ContactCell         &cell    = all_cells[c];
          Zone                      &zone    = all_zones[cell.zone];
          const IntermediateGeometry between = geometry(curves, cell);
          const bool                 goes_on =
            n_begun == begins.size() || first_cells[n_begun].cell != c;
          const CellEnd begin = goes_on ? ends[k - 1] : begins[n_begun++];

          const auto   first = elements.size();
          const double penetration =
            place_in_cell(between,
                          begin,
                          ends[k],
                          between.a.radius + between.b.radius - cell.forgiven,
                          skin * zone.radius,
                          /*aligned=*/cell.level == 0,
                          elements);
          zone.penetration    = std::max(zone.penetration, penetration);
          const NormalLaw law = this->law(cell.zone, threshold, skin);
          for (auto e = first; e < elements.size(); ++e)
            {
              ContactElement &element = elements[e];
              element.fiber_a         = cell.fiber_a;
              element.fiber_b         = cell.fiber_b;
              element.zone            = cell.zone;
              element.cell            = c;
              element.orientation     = cell.orientation;
              element.penalty         = cell.penalty;
              element.forgiven        = cell.forgiven;
              element.force =
                element.weight *
                law.pressure(cell.penalty, std::max(-element.gap, -law.skin));
            }
        }
    }



    std::vector<CandidatePair>
    ContactCells::near_pairs(const CurveList &curves,
                             const double     approach) const
    {
      std::vector<CandidatePair> pairs;
      for (const ContactCell &cell : all_cells)
        if (cell.clearance <= approach)
          {
            const IntermediateGeometry between = geometry(curves, cell);
            const auto                 p       = range(cell, between);
            const double               sigma   = cell.orientation;
            for (const double t : {0., 0.5, 1.})
              {
                const double along = p.first + t * (p.second - p.first);
                const double q = cell.q_begin + t * (cell.q_end - cell.q_begin);
                pairs.push_back(
                  {cell.fiber_a,
                   cell.fiber_b,
                   between.a.interval(0.5 * (along + q)),
                   between.b.interval(0.5 * sigma * (along - q))});
              }
          }
      sort_and_unify(pairs);
      return pairs;
    }



    bool
    ContactCells::adapt(const double threshold)
    {
      bool changed = false;
      for (ContactCell &cell : all_cells)
        {
          const Zone  &zone        = all_zones[cell.zone];
          const double penetration = zone.penetration / zone.radius;
          if (penetration > near * threshold && !is_stiffest(cell))
            {
              const double growth =
                growth_of_penalty(cell, penetration, safety * threshold);
              cell.penalty *= growth;
              cell.hardened *= growth;
              cell.raised_by  = growth;
              cell.raised_for = penetration;
              changed         = true;
            }
        }
      return changed;
    }



    bool
    ContactCells::is_stiffest(const ContactCell &cell) const
    {
      return cell.penalty >
             stiffest * cell.kept * first_penalty(cell.fiber_a, cell.fiber_b);
    }
  } // namespace Contact
} // namespace Heddle
