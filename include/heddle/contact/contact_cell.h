#ifndef heddle_contact_contact_cell_h
#define heddle_contact_contact_cell_h

#include <heddle/contact/contact_element.h>
#include <heddle/contact/intermediate_geometry.h>

#include <array>
#include <tuple>
#include <vector>

namespace Heddle
{
  namespace Contact
  {
    /**
     * One cell of the discretisation of an intermediate geometry: the range
     * [number, number + 1] times a size, of its coordinate p. Cells do not move
     * with the zone that they belong to, so a search that finds a longer or a
     * shorter zone changes no force. The size is that of a whole cell divided
     * by two, @p level times: fibers at an angle part quickly.
     */
    struct ContactCell
    {
      unsigned int fiber_a, fiber_b;
      int          orientation;
      unsigned int level;
      int          number;
      unsigned int zone;
      double       q_begin; /**< guess of s_a - sigma s_b at its begin [mm] */
      double       q_end;   /**< the same at its end [mm] */
      double       penalty; /**< [N/mm^2] */

      /** By how much the sum of the radii is taken smaller [mm]. */
      double forgiven = 0.;

      /**
       * At least so far apart are the surfaces, less how far both fibers have
       * moved since they were last searched as a whole [mm].
       */
      double clearance = 0.;

      /** Penalty over what it would be if the orientation had not been kept. */
      double kept = 1.;

      /** Penalty over that of the last accepted step. */
      double hardened = 1.;

      /** By how much the penalty was raised last in this step, ... */
      double raised_by = 1.;

      /** ... and for which penetration, in radii. */
      double raised_for = 0.;
    };

    inline bool
    operator<(const ContactCell &left, const ContactCell &right)
    {
      return std::tie(left.fiber_a,
                      left.fiber_b,
                      left.orientation,
                      left.level,
                      left.number,
                      left.q_begin) < std::tie(right.fiber_a,
                                               right.fiber_b,
                                               right.orientation,
                                               right.level,
                                               right.number,
                                               right.q_begin);
    }

    /** Distance and particles at one end of a cell. */
    struct CellEnd
    {
      double    p;                /**< [mm] */
      double    q;                /**< [mm] */
      double    squared_distance; /**< of the axes [mm^2] */
      double    slope;            /**< of that along p [mm] */
      FacingEnd end;
    };

    /** Evaluate the particles at @p p with the guess @p q. */
    CellEnd
    cell_end(const IntermediateGeometry &geometry,
             const double                p,
             const double                q);

    /** So many ends take about as long as one. */
    constexpr unsigned int n_ends_at_once = 4;

    /** The same in several geometries. */
    std::array<CellEnd, n_ends_at_once>
    cell_ends(const std::array<const IntermediateGeometry *, n_ends_at_once>
                                                       &geometries,
              const std::array<double, n_ends_at_once> &p,
              std::array<double, n_ends_at_once>        q);

    /**
     * The axes are no closer to each other between these ends, as far as the
     * cubic tells that interpolates the squared distance and its slope [mm].
     */
    double
    least_distance(const IntermediateGeometry &geometry,
                   const CellEnd              &begin,
                   const CellEnd              &end);

    /**
     * Append the contact elements of one cell to @p elements and return the
     * largest penetration in it [mm], 0 if the fibers do not touch there.
     * Surfaces that wear a skin touch where their gap is less than @p skin
     * [mm]. Axes of fibers that touch are @p distance_at_contact apart [mm].
     *
     * Across the cell of two @p aligned fibers the gap changes by little: its
     * four Gauss points are elements where they touch. That is as smooth as the
     * normal law, however curved the fibers.
     *
     * Fibers at an angle touch in a short stretch inside the cell. Where it is
     * is found from the cubic that interpolates the squared distance and its
     * slope at the cell's ends: exact for straight fibers at any angle. The
     * stretch gets four elements, at its Gauss points: a crossing that slides
     * from one cell into the next then feels less than 1 % of that, with two it
     * would be 18 %.
     *
     * Where the end of a fiber comes to face the other one, the distance has a
     * kink: the cell is cut there.
     *
     * Gap, normal, weight and particles of the elements are set; force and
     * penalty are not.
     */
    double
    place_in_cell(const IntermediateGeometry  &geometry,
                  const CellEnd               &begin,
                  const CellEnd               &end,
                  const double                 distance_at_contact,
                  const double                 skin,
                  const bool                   aligned,
                  std::vector<ContactElement> &elements);
  } // namespace Contact
} // namespace Heddle

#endif
