#include <heddle/contact/contact_cells.h>

#include <deal.II/base/numbers.h>

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
       * Fibers at an angle touch over a small part of the length over which
       * parallel ones do, and carry as much: their first penalty is so many
       * times larger.
       */
      constexpr double crossing_factor = 10.;



      /** Largest parting of fibers across half an aligned cell, in radii. */
      constexpr double aligned_parting = 0.2;

      /** The squared distance is nearly a cubic within cells of this level. */
      constexpr unsigned int least_level_of_crossing = 2;



      /** The angle of a zone may change by this factor before its cells do. */
      constexpr double slack = 1.25;



      /**
       * Across an aligned cell the fibers part by little. At larger angles the
       * stretch in which they touch has to be found in a cell: short ones, in
       * which they part by no more than about a radius. @p parting is that
       * across half a whole cell, in radii.
       */
      unsigned int
      level_for(const double parting)
      {
        unsigned int level =
          parting > aligned_parting ? least_level_of_crossing : 0;
        while (parting / (1u << level) > 1.)
          ++level;
        return level;
      }



      /**
       * Crossing fibers part like p sin(angle / 2), so that their force goes
       * like penalty / sin(angle / 2). If they keep their orientation beyond a
       * right angle, by this factor of the penalty they feel the force of the
       * other one.
       */
      double
      factor_if_kept(const double cosine)
      {
        return cosine < 0. ? std::sqrt((1. - cosine) / (1. + cosine)) : 1.;
      }



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



    void
    ContactCells::search(const CurveList           &curves,
                         const std::vector<double> &moved,
                         const Filter              &filter)
    {
      const std::vector<CandidatePair> candidates =
        find_candidates(curves.all(), search_distance);

      std::vector<ContactCell> old_cells;
      old_cells.swap(all_cells);
      keep_cells(curves, old_cells);
      const auto n_kept = all_cells.size();
      for (auto first = candidates.begin(); first != candidates.end();)
        {
          auto last = first;
          while (last != candidates.end() && last->fiber_a == first->fiber_a &&
                 last->fiber_b == first->fiber_b)
            ++last;
          if (filter(first->fiber_a, first->fiber_b))
            {
              const Curve   &a = curves[first->fiber_a];
              const Curve   &b = curves[first->fiber_b];
              const OldCells old(
                first->fiber_a, first->fiber_b, whole_cell(a, b), old_cells);
              const auto known = [&](const double s_a, const double s_b) {
                const ContactCell *before = old.nearest(s_a, s_b);
                return before != nullptr ? before->orientation : 0;
              };
              const auto first_of_pair = all_cells.size();
              for (const ProximityZone &zone :
                   find_zones(&*first, &*first + (last - first), a, b, known))
                cover_zone(curves, moved, zone, old, first_of_pair);
              std::sort(all_cells.begin() + first_of_pair, all_cells.end());
            }
          first = last;
        }
      std::inplace_merge(
        all_cells.begin(), all_cells.begin() + n_kept, all_cells.end());
    }



    void
    ContactCells::keep_cells(const CurveList                &curves,
                             const std::vector<ContactCell> &old_cells)
    {
      std::vector<Zone>         old_zones;
      std::vector<unsigned int> number;
      old_zones.swap(all_zones);
      number.assign(old_zones.size(), numbers::invalid_unsigned_int);
      for (const ContactCell &cell : old_cells)
        if (!curves.is_stale(cell.fiber_a) && !curves.is_stale(cell.fiber_b))
          {
            if (number[cell.zone] == numbers::invalid_unsigned_int)
              {
                number[cell.zone] = all_zones.size();
                all_zones.push_back(old_zones[cell.zone]);
              }
            all_cells.push_back(cell);
            all_cells.back().zone = number[cell.zone];
          }
    }



    void
    ContactCells::cover_zone(const CurveList           &curves,
                             const std::vector<double> &moved,
                             const ProximityZone       &zone,
                             const OldCells            &old_cells,
                             const std::size_t          first_of_pair)
    {
      ContactCell cell                   = {};
      cell.fiber_a                       = zone.fiber_a;
      cell.fiber_b                       = zone.fiber_b;
      cell.orientation                   = zone.orientation;
      cell.zone                          = all_zones.size();
      cell.forgiven                      = forgiven_for(cell);
      cell.kept                          = factor_if_kept(zone.cosine);
      const IntermediateGeometry between = geometry(curves, cell);
      const Curve               &a = between.a, &b = between.b;

      // A zone keeps the cells that it had while its angle changes by little:
      // other cells, though as good, mean other forces.
      const double       whole   = whole_cell(a, b);
      const double       radius  = std::min(a.radius, b.radius);
      const double       parting = 0.5 * whole * zone.sine;
      const auto         closest = zone.closest();
      const ContactCell *before =
        old_cells.nearest(closest.first, closest.second);
      cell.level = level_for(parting / radius);
      if (before != nullptr)
        cell.level = std::clamp(before->level,
                                level_for(parting / radius / slack),
                                level_for(parting / radius * slack));
      const double size = whole / (1u << cell.level);

      const double first_p = std::max(zone.begin, between.range().first);
      const double last_p  = std::min(zone.end, between.range().second);
      if (first_p >= last_p)
        return;
      all_zones.push_back({0., radius});

      const double at_contact    = a.radius + b.radius;
      const auto   first_of_zone = all_cells.size();
      double       known_penalty = 0.;
      CellEnd      end           = {};
      bool         continues     = false;
      for (cell.number = std::floor(first_p / size);
           cell.number * size < last_p;
           ++cell.number)
        {
          // Neighbours share an end, and where fibers are close, particles
          // beyond it are near those at it.
          const auto p = range(cell, between);
          CellEnd    begin =
            continues ? end : cell_end(between, p.first, zone.guess(p.first));
          const double gap = std::sqrt(begin.squared_distance) - at_contact;
          continues        = gap < search_distance;

          // The distance changes by no more than p: so many cells are too far.
          const double excess = gap - search_distance;
          if (excess > size)
            {
              cell.number += static_cast<int>(excess / size) - 1;
              continue;
            }
          end = cell_end(
            between, p.second, continues ? begin.q : zone.guess(p.second));
          if (std::abs(end.q - begin.q) > at_contact)
            {
              // Strongly bent fibers face each other in several places.
              const double q = zone.guess(0.5 * (p.first + p.second));
              begin          = cell_end(between, p.first, q);
              end            = cell_end(between, p.second, q);
            }
          cell.clearance = least_distance(between, begin, end) - at_contact;
          if (cell.clearance > search_distance)
            continue;
          cell.clearance -= moved[cell.fiber_a] + moved[cell.fiber_b];
          cell.q_begin = begin.q;
          cell.q_end   = end.q;
          if (is_covered(cell, size, first_of_pair, first_of_zone))
            continue;
          const ContactCell *old = old_cells.stiffest(cell);
          cell.penalty    = old ? old->penalty / old->kept * cell.kept : 0.;
          cell.hardened   = old ? old->hardened : 1.;
          cell.raised_by  = old ? old->raised_by : 1.;
          cell.raised_for = old ? old->raised_for : 0.;
          known_penalty   = std::max(known_penalty, cell.penalty);
          all_cells.push_back(cell);
        }

      // A zone that grew is as stiff in its new cells as in its old ones.
      if (known_penalty == 0.)
        known_penalty = first_penalty(zone.fiber_a, zone.fiber_b) * cell.kept *
                        (parting > radius ? crossing_factor : 1.);
      for (auto k = first_of_zone; k < all_cells.size(); ++k)
        if (all_cells[k].penalty == 0.)
          all_cells[k].penalty = known_penalty;
    }



    bool
    ContactCells::is_covered(const ContactCell &cell,
                             const double       size,
                             const std::size_t  first_of_pair,
                             const std::size_t  first_of_zone) const
    {
      for (std::size_t k = first_of_pair; k < first_of_zone; ++k)
        {
          const ContactCell &other = all_cells[k];
          if (other.number == cell.number && other.level == cell.level &&
              other.orientation == cell.orientation &&
              std::abs(other.q_begin - cell.q_begin) < size)
            return true;
        }
      return false;
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



    void
    ContactCells::adapt(const double threshold)
    {
      for (ContactCell &cell : all_cells)
        {
          const Zone  &zone        = all_zones[cell.zone];
          const double penetration = zone.penetration / zone.radius;
          if (penetration > near * threshold)
            {
              const double growth =
                growth_of_penalty(cell, penetration, safety * threshold);
              cell.penalty *= growth;
              cell.hardened *= growth;
              cell.raised_by  = growth;
              cell.raised_for = penetration;
            }
        }
    }
  } // namespace Contact
} // namespace Heddle
