#include <heddle/contact/old_cells.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace Heddle
{
  namespace Contact
  {
    OldCells::OldCells(const unsigned int              fiber_a,
                       const unsigned int              fiber_b,
                       const double                    whole,
                       const std::vector<ContactCell> &cells)
      : whole(whole)
    {
      const auto before =
        [](const ContactCell                           &cell,
           const std::pair<unsigned int, unsigned int> &pair) {
          return std::tie(cell.fiber_a, cell.fiber_b) <
                 std::tie(pair.first, pair.second);
        };
      const auto begin = std::lower_bound(
        cells.begin(), cells.end(), std::make_pair(fiber_a, fiber_b), before);
      const auto end = std::lower_bound(
        begin, cells.end(), std::make_pair(fiber_a, fiber_b + 1), before);
      first = cells.data() + (begin - cells.begin());
      last  = cells.data() + (end - cells.begin());
    }



    OldCells::Place
    OldCells::place_of(const ContactCell &cell) const
    {
      const double size = whole / (1u << cell.level);
      const double p    = (cell.number + 0.5) * size;
      const double q    = 0.5 * (cell.q_begin + cell.q_end);
      return {size, p, q, 0.5 * (p + q), 0.5 * cell.orientation * (p - q)};
    }



    const ContactCell *
    OldCells::nearest(const double s_a, const double s_b) const
    {
      double             nearest = 2. * whole;
      const ContactCell *found   = nullptr;
      for (const ContactCell *old = first; old != last; ++old)
        {
          const Place  there = place_of(*old);
          const double apart =
            std::abs(there.s_a - s_a) + std::abs(there.s_b - s_b);
          if (apart < nearest)
            {
              nearest = apart;
              found   = old;
            }
        }
      return found;
    }



    const ContactCell *
    OldCells::stiffest(const ContactCell &cell) const
    {
      // The cell itself, one of another level that covers its middle, or, where
      // the fibers turned through a right angle, one of the other orientation
      // between the same particles.
      const Place        here  = place_of(cell);
      const ContactCell *found = nullptr;
      for (const ContactCell *kind = first; kind != last;)
        {
          // Those of one kind follow each other by their numbers: look at what
          // may be near.
          const ContactCell *kind_end = std::upper_bound(
            kind,
            last,
            *kind,
            [](const ContactCell &one, const ContactCell &other) {
              return std::tie(one.orientation, one.level) <
                     std::tie(other.orientation, other.level);
            });
          const bool   alike = kind->orientation == cell.orientation;
          const double size  = whole / (1u << kind->level);
          const double close = 0.3 * (size + here.size);
          const double reach = alike ? 0.51 * size : 2. * close;
          const double middle =
            alike ? here.p : here.s_a + kind->orientation * here.s_b;
          const int          lowest = std::floor((middle - reach) / size - 0.5);
          const int          highest = std::ceil((middle + reach) / size - 0.5);
          const ContactCell *begin =
            std::lower_bound(kind,
                             kind_end,
                             lowest,
                             [](const ContactCell &old, const int number) {
                               return old.number < number;
                             });
          for (const ContactCell *old = begin;
               old != kind_end && old->number <= highest;
               ++old)
            {
              const Place there = place_of(*old);
              const bool  same  = alike
                                    ? std::abs(there.p - here.p) < 0.51 * size &&
                                      std::abs(there.q - here.q) < whole
                                    : std::abs(there.s_a - here.s_a) < close &&
                                      std::abs(there.s_b - here.s_b) < close;
              if (same && (!found || old->penalty > found->penalty))
                found = old;
            }
          kind = kind_end;
        }
      return found;
    }
  } // namespace Contact
} // namespace Heddle
