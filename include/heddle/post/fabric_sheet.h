#ifndef heddle_post_fabric_sheet_h
#define heddle_post_fabric_sheet_h

#include <heddle/post/fabric_window.h>
#include <heddle/post/fiber_orientation.h>

#include <map>
#include <string>
#include <vector>

namespace Heddle
{
  namespace Post
  {
    /**
     * What a data sheet says of a fabric: its thickness, what it weighs, how
     * much of it is fibers, and how these run. Of yarns of two sets that make a
     * FabricWindow what lies in this is measured, of others all there is.
     */
    class FabricSheet
    {
    public:
      /** @pre There are @p yarns. */
      explicit FabricSheet(const std::vector<YarnBody> &yarns);

      /**
       * Add to @p results, by name with unit, the thickness, orientation
       * tensors, of all yarns and of each set, and of a fabric with a window
       * spacings and crimp of its yarns, the volume fraction of its fibers and,
       * if all densities are known, its areal weight.
       */
      void
      add_to(std::map<std::string, double> &results) const;

      /** From the lowest surface of a fiber to the highest one [mm]. */
      double
      thickness() const
      {
        return highest - lowest;
      }

      /** Fiber volume over the volume of the fabric; 0 without a window [-]. */
      double
      volume_fraction() const;

      /** How fibers run, as CSV: a line for each class of both angles. */
      std::string
      orientation_csv() const;

    private:
      /** The yarns of one name. */
      struct Set
      {
        std::string      name;
        FiberOrientation orientation; /**< weighted by volume */
        double           mass   = 0.; /**< [mm^3 g/cm^3] */
        double           area   = 0.; /**< of the fabric; 0: no window [mm^2] */
        double           length = 0.; /**< of all mean lines [mm] */
        double           way    = 0.; /**< of these along the yarns [mm] */
      };

      /** Number of the set of this name. @pre There is one. */
      unsigned int
      number_of(const std::string &name) const;

      /** Add the piece from @p a to @p b of fiber @p f. */
      void
      add_piece(const YarnBody     &yarn,
                const unsigned int  f,
                const Tensor<1, 3> &a,
                const Tensor<1, 3> &b);

      /** Add what the mean line lies within the window. */
      void
      add_crimp(const YarnBody &yarn);

      /** How the fibers of all sets run, by their volume per area. */
      FiberOrientation
      of_all() const;

      std::vector<Set> sets;
      FabricWindow     window;
      bool             is_weighed = true; /**< all densities are known */

      /** Surfaces of fibers, of all that is measured [mm]. */
      double lowest, highest;
    };
  } // namespace Post
} // namespace Heddle

#endif
