#ifndef heddle_contact_contact_cell_h
#define heddle_contact_contact_cell_h

#include <heddle/contact/contact_element.h>
#include <heddle/contact/intermediate_geometry.h>

#include <tuple>
#include <vector>

namespace Heddle
{
  namespace Contact
  {
    /**
     * One cell of the discretisation of an intermediate geometry: the range
     * [number, number + 1] times the cell size of its coordinate p. Cells do
     * not move with the zone that they belong to, so a search that finds a
     * longer or a shorter zone changes no force.
     */
    struct ContactCell
    {
      unsigned int fiber_a, fiber_b;
      int          orientation;
      int          number;
      unsigned int zone;
      double       q;       /**< s_a - sigma s_b at its begin [mm] */
      double       penalty; /**< [N/mm^2] */
    };

    inline bool
    operator<(const ContactCell &left, const ContactCell &right)
    {
      return std::tie(left.fiber_a,
                      left.fiber_b,
                      left.orientation,
                      left.number,
                      left.q) < std::tie(right.fiber_a,
                                         right.fiber_b,
                                         right.orientation,
                                         right.number,
                                         right.q);
    }

    /** Distance and particles at one end of a cell. */
    struct CellEnd
    {
      double p;
      double q;
      double squared_distance;
      double slope;
    };

    /** Evaluate the particles at @p p with the guess @p q. */
    CellEnd
    cell_end(const IntermediateGeometry &geometry,
             const double                p,
             const double                q);

    /**
     * Append the contact elements of one cell to @p elements and return the
     * largest penetration in it [mm], 0 if the fibers do not touch there.
     *
     * Where the surfaces overlap, within the cell, is found from the cubic that
     * interpolates the squared distance and its slope at the cell's ends: exact
     * for straight fibers at any angle. Each stretch of overlap gets two
     * elements, at its Gauss points. A cell of two parallel fibers is one
     * stretch; a crossing is a short one inside a cell; and everything between
     * is between, so that forces are continuous in the configuration and no
     * angle separates two treatments.
     *
     * Gap, normal, weight and particles of the elements are set; force and
     * penalty are not.
     */
    double
    place_elements(const IntermediateGeometry & geometry,
                   const CellEnd &              begin,
                   const CellEnd &              end,
                   std::vector<ContactElement> &elements);
  } // namespace Contact
} // namespace Heddle

#endif
