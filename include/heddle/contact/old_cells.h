#ifndef heddle_contact_old_cells_h
#define heddle_contact_old_cells_h

#include <heddle/contact/contact_cell.h>

#include <vector>

namespace Heddle
{
  namespace Contact
  {
    /**
     * The cells that a pair of fibers had before a search, from which new ones
     * inherit: a view of a part of all cells.
     */
    class OldCells
    {
    public:
      /**
       * View those of two fibers among @p cells, which are sorted. @p whole is
       * the size of whole cells of these fibers [mm].
       */
      OldCells(const unsigned int              fiber_a,
               const unsigned int              fiber_b,
               const double                    whole,
               const std::vector<ContactCell> &cells);

      /** The one nearest to these particles [mm]; nullptr if all are far. */
      const ContactCell *
      nearest(const double s_a, const double s_b) const;

      /** The stiffest one where @p cell is now; nullptr if there is none. */
      const ContactCell *
      stiffest(const ContactCell &cell) const;

    private:
      /** The middle of a cell, and the particles that face each other there. */
      struct Place
      {
        double size, p, q, s_a, s_b; /**< [mm] */
      };

      Place
      place_of(const ContactCell &cell) const;

      const double       whole;
      const ContactCell *first, *last;
    };
  } // namespace Contact
} // namespace Heddle

#endif
