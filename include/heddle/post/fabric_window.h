#ifndef heddle_post_fabric_window_h
#define heddle_post_fabric_window_h

#include <heddle/base/columns.h>
#include <heddle/base/polyline.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace Heddle
{
  namespace Post
  {
    /** A yarn as it lies in the fabric. */
    struct YarnBody
    {
      std::string           set;
      std::vector<Polyline> lines; /**< of its fibers [mm] */
      std::vector<double>   radii; /**< of these [mm] */

      /** Of these as they are, stretched; 0: not known [g/cm^3]. */
      std::vector<double> densities;

      /** Its mean line [mm]. */
      Polyline mean;
    };



    /**
     * The part of a fabric that is measured: the parallelogram in its plane
     * whose sides are the axes of the outer yarns. Ends of yarns that stick out
     * are not in it. Points of the plane have the coordinates
     * $x = x_0 + \xi_0 e_0 + \xi_1 e_1$ with a point $x_0$ amid the fabric,
     * lest directions matter that differ by little, and the mean directions
     * $e_d$ of both sets of yarns, which need not be at right angles, as in a
     * fabric that is sheared.
     */
    class FabricWindow
    {
    public:
      /** Of two sets of yarns. */
      explicit FabricWindow(const std::array<std::vector<YarnBody>, 2> &sets);

      /**
       * Whether there is one: both sets have two yarns side by side, and they
       * cross at 12 degrees or more. The members below need one.
       */
      bool
      found() const
      {
        return is_found;
      }

      /** From axis to axis of neighbouring yarns of set @p d, across them [mm].
       */
      double
      spacing(const unsigned int d) const
      {
        return columns[d].spacing() * sine;
      }

      /**
       * Area of the fabric in which all yarns of set @p d lie, between the
       * outer yarns of the other set [mm^2]. Outer yarns count as whole: there
       * are as many distances between yarns as yarns side by side.
       */
      double
      area(const unsigned int d) const
      {
        return columns[d].n * spacing(d) *
               (columns[1 - d].last - columns[1 - d].first);
      }

      /**
       * The part of the straight piece from @p a to @p b that lies between the
       * outer yarns that set @p d crosses: fractions of the piece from where to
       * where, of which the second is not above the first if there is none.
       */
      std::pair<double, double>
      part_between(const unsigned int  d,
                   const Tensor<1, 3> &a,
                   const Tensor<1, 3> &b) const;

      /** How far a @p piece goes along $e_d$ [mm]. */
      double
      component(const unsigned int d, const Tensor<1, 3> &piece) const;

      /** Whether a point lies between the outer yarns that set @p d crosses, or
       * within @p margin of them [mm]. */
      bool
      is_between(const unsigned int  d,
                 const Tensor<1, 3> &point,
                 const double        margin) const;

    private:
      /** Coordinate $\xi_d$ of a point [mm]. */
      double
      coordinate(const unsigned int d, const Tensor<1, 3> &point) const
      {
        return component(d, point - origin);
      }

      /** Whether a point of set @p d tells where its yarn lies: all do as long
       * as it is not known which lie between the yarns that it crosses. */
      bool
      counts(const unsigned int d, const Tensor<1, 3> &point) const;

      /** Mean direction of the yarns of set @p d in the plane, whichever end
       * they begin at; 0 if they have none. */
      Tensor<1, 3>
      mean_direction(const std::vector<YarnBody> &yarns,
                     const unsigned int           d) const;

      /** Where the yarns of set @p d lie across it. */
      Columns
      find_columns(const std::vector<YarnBody> &yarns,
                   const unsigned int           d) const;

      Tensor<1, 3>                origin;
      std::array<Tensor<1, 3>, 2> directions;
      std::array<Columns, 2>      columns; /**< of each set, across it */
      double                      sine     = 0.;
      bool                        is_found = false;
    };
  } // namespace Post
} // namespace Heddle

#endif
