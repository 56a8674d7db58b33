// How proximity zones are covered by cells, anew or as they were.
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
      /**
       * The stretch over which fibers at an angle touch is shorter by its sine
       * than that of parallel ones, and carries as much: the first penalty of
       * those at a right angle is so many times larger.
       */
      constexpr double crossing_factor = 10.;



      /** Largest parting of fibers across half an aligned cell, in radii. */
      constexpr double aligned_parting = 0.2;

      /** The squared distance is nearly a cubic within cells of this level. */
      constexpr unsigned int least_level_of_crossing = 2;



      /** From cell to cell, in their sizes, q changes by less along a zone. */
      constexpr double jump = 0.1;



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
       * Where cells of @p size end that follow each other along a zone. Some
       * are looked for at once, with the same guess: q hardly changes.
       */
      class EndsAhead
      {
      public:
        EndsAhead(const IntermediateGeometry &between, const double size)
          : size(size)
          , last_p(between.range().second)
        {
          geometries.fill(&between);
        }

        /** That of cell @p number; @p q is the guess if it is not known. */
        const CellEnd &
        of(const int number, const double q)
        {
          if (number < first || number >= first + n_known)
            {
              std::array<double, n_ends_at_once> p, guess;
              for (unsigned int k = 0; k < n_ends_at_once; ++k)
                p[k] = std::min((number + 1. + k) * size, last_p);
              guess.fill(q);
              ends    = cell_ends(geometries, p, guess);
              first   = number;
              n_known = n_ends_at_once;
            }
          return ends[number - first];
        }

      private:
        const double                                             size, last_p;
        std::array<const IntermediateGeometry *, n_ends_at_once> geometries;
        std::array<CellEnd, n_ends_at_once>                      ends;
        int first = 0, n_known = 0;
      };
    } // namespace



    void
    ContactCells::search(const CurveList           &curves,
                         const std::vector<double> &moved,
                         const Filter              &filter)
    {
      const std::vector<CandidatePair> candidates =
        find_candidates(curves.all(), search_distance);

      std::vector<ContactCell> old_cells;
      old_cells.swap(all_cells);
      all_cells.reserve(old_cells.size() + old_cells.size() / 16);
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

      // Where contacts have become many more, their room has doubled.
      if (all_cells.capacity() > all_cells.size() + all_cells.size() / 8)
        all_cells.shrink_to_fit();
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
      EndsAhead    ahead(between, size);
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
          if (continues)
            end = ahead.of(cell.number, begin.q);
          if (!continues || std::abs(end.q - begin.q) > jump * size)
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
                        std::max(1., crossing_factor * zone.sine);
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
  } // namespace Contact
} // namespace Heddle
