#ifndef heddle_contributions_fabric_supports_h
#define heddle_contributions_fabric_supports_h

#include <heddle/contributions/fabric_bending.h>
#include <heddle/contributions/fabric_motion.h>
#include <heddle/contributions/supports.h>

#include <optional>
#include <string>
#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /** One load case of a woven sample. */
    struct FabricCase
    {
      std::string  name;
      SupportList  supports; /**< of the sides x-, x+, y-, y+ */
      FabricMotion motion;

      /** Whether it is pulled along warp and weft: their length is a load. */
      FabricMotion::Both<bool> pulls;

      /** Then nothing else moves. */
      std::optional<FabricBending> bending;
    };



    /** Of warp and weft: what their forces are divided by. */
    struct FabricSize
    {
      FabricMotion::Both<double>       width;   /**< across them [mm] */
      FabricMotion::Both<unsigned int> n_yarns; /**< of all layers */
    };



    /**
     * The supports of the four sides of a woven sample, and what a test of it
     * measures: lengths, forces, couple and, where it is bent, the moment.
     */
    class FabricSupports : public Supports
    {
    public:
      /** @p test is to live as long as this. */
      FabricSupports(const System::FiberSpace        &space,
                     const std::vector<Tensor<1, 3>> &reference,
                     const FabricCase                &test,
                     const FabricSize                &size);

      void
      begin_stage(const System::State &state) override;

      void
      observe(const System::BlockSystem &system) override;

      /** That of all supports, and the test's strains, forces, stiffnesses. */
      void
      report(const System::State           &state,
             std::map<std::string, double> &values) const override;

      void
      accept_step(const System::State &state) override;

      /** Whether @p archive has a fabric that such supports shear or bend. */
      static bool
      hold_askew(const ArchiveReader &archive);

      /** Also what stiffnesses are differences to. */
      void
      save(ArchiveWriter &archive, const System::State &state) const override;

      void
      load(const ArchiveReader &archive, const System::State &state) override;

      /** Where a point at @p place is if the sample is flattened again: there,
       * unless it is bent. */
      Tensor<1, 3>
      flattened(const Tensor<1, 3> &place, const double load_factor) const
      {
        return test.bending
                 ? origin + test.bending->flattened(place - origin, load_factor)
                 : place;
      }

    private:
      template <typename Value>
      using Both = FabricMotion::Both<Value>;

      /** What is measured in one configuration. */
      struct Measured
      {
        Both<double> length        = {}; /**< between the sides [mm] */
        Both<double> force         = {}; /**< mean of the two sides [N] */
        Both<double> matrix_force  = {}; /**< part of it on the matrix [N] */
        Both<double> work_force    = {}; /**< conjugate to the length [N] */
        double       angle         = 0.; /**< shear angle [rad] */
        double       couple        = 0.; /**< conjugate to it [N mm] */
        double       matrix_couple = 0.; /**< part of it [N mm] */
        double       curvature     = 0.; /**< [1/mm] */
        double       moment        = 0.; /**< conjugate to the turn [N mm] */
        double       matrix_moment = 0.; /**< part of it [N mm] */
      };

      static constexpr unsigned int n_sides = 4;

      /** Sums over all that is held on one side. */
      struct SideSums
      {
        Tensor<1, 3> force;       /**< [N] */
        Tensor<1, 3> of_matrix;   /**< part of it on the matrix [N] */
        Tensor<1, 3> ends;        /**< positions of the ends of fibers [mm] */
        double       n_ends = 0.; /**< [-] */
      };

      /** Sums over all that is held, of this rank and then of all. */
      struct Sums
      {
        std::array<SideSums, n_sides> sides;
        Both<double> work          = {}; /**< conjugate to the strains [N mm] */
        double       couple        = 0.; /**< conjugate to the angle [N mm] */
        double       matrix_couple = 0.; /**< part of it [N mm] */
        double       bending       = 0.; /**< to the curvature [N mm^2] */
        double       of_matrix     = 0.; /**< part of it [N mm^2] */
      };

      /** How the sides move at one load factor, see FabricMotion. */
      struct Kinematics
      {
        Kinematics(const FabricMotion &motion, const double load_factor);

        Both<Tensor<1, 3>> along, turning;
        Both<double>       stretch, turn_rates;
      };

      /** Add what the @p force on a held position, now at @p place, does. */
      void
      add_position(const HeldBlock    &held,
                   const unsigned int  sides,
                   const Tensor<1, 3> &force,
                   const Tensor<1, 3> &place,
                   const Kinematics   &kinematics,
                   Sums               &sums) const;

      /** The @p force on a held block: its work for a unit of curvature
       * [N mm^2]. */
      double
      bending_work(const HeldBlock    &held,
                   const Tensor<1, 3> &force,
                   const Tensor<1, 3> &value,
                   const double        load_factor) const;

      /** Return what is measured, by sums over all ranks. */
      Measured
      measure(const Sums       &sums,
              const Kinematics &kinematics,
              const double      load_factor) const;

      /**
       * Find on which sides the held blocks are, the point amid these and the
       * lengths at rest.
       */
      void
      find_sides(const System::State &state);

      /**
       * The mean height of the yarns that are bent, along their length and by
       * their axial stiffness: where a moment alone bends them they keep their
       * length there [mm].
       */
      double
      neutral_height(const System::State &state) const;

      /** What forces and couples are divided by. */
      void
      find_areas();

      /** From the middles of the four sides, by the ends of the fibers. */
      Both<double>
      lengths(const std::array<Tensor<1, 3>, n_sides> &middles,
              const double                             load_factor) const;

      void
      report_bending(std::map<std::string, double> &values) const;

      /** Difference quotient over the last step, NaN if nothing moved. */
      static double
      slope(const double value,
            const double value_before,
            const double at,
            const double at_before);

      const FabricCase         &test;
      const FabricSize          size;
      std::vector<unsigned int> sides_of; /**< bits, of each held block */
      std::array<Tensor<1, 3>, n_sides> rest_middles; /**< of the sides [mm] */
      Both<double>                      rest_length = {};
      Both<double> matrix_width = {}; /**< 0 without one [mm] */
      double       sheared_area = 0.; /**< [mm^2] */
      Measured     now, last, before;
    };
  } // namespace Contributions
} // namespace Heddle

#endif
