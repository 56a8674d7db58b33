#ifndef heddle_simulation_fabric_loading_parameters_h
#define heddle_simulation_fabric_loading_parameters_h

#include <heddle/base/yarn_set.h>
#include <heddle/contributions/fabric_supports.h>

#include <deal.II/base/parameter_acceptor.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace Simulation
  {
    using namespace dealii;

    /** Tests of a fabric. */
    enum class FabricTest
    {
      none,
      biaxial_tension,
      uniaxial_tension,
      picture_frame,
      simple_shear,
      bending,
      held
    };

    /** How the user names them. */
    constexpr const char *
    word(const FabricTest test)
    {
      switch (test)
        {
          case FabricTest::none:
            return "none";
          case FabricTest::biaxial_tension:
            return "biaxial tension";
          case FabricTest::uniaxial_tension:
            return "uniaxial tension";
          case FabricTest::picture_frame:
            return "picture frame";
          case FabricTest::simple_shear:
            return "simple shear";
          case FabricTest::bending:
            return "bending";
          case FabricTest::held:
            return "held";
        }
      return nullptr;
    }

    /** What sides do along which a fabric is not pulled. */
    enum class FreeSides
    {
      free,
      held
    };

    /** How the user names them. */
    constexpr const char *
    word(const FreeSides sides)
    {
      switch (sides)
        {
          case FreeSides::free:
            return "free";
          case FreeSides::held:
            return "held";
        }
      return nullptr;
    }

    /** What sections at the ends of fibers do. */
    enum class SideSections
    {
      hinged, /**< they are free to turn */
      clamped /**< they turn with the fabric */
    };

    /** How the user names them. */
    constexpr const char *
    word(const SideSections ends)
    {
      switch (ends)
        {
          case SideSections::hinged:
            return "hinged";
          case SideSections::clamped:
            return "clamped";
        }
      return nullptr;
    }



    /** What the ends of yarns do where a matrix is sheared. */
    enum class YarnEnds
    {
      embedded, /**< across the yarn they go with the matrix */
      gripped   /**< those of a yarn turn as one body */
    };

    /** How the user names them. */
    constexpr const char *
    word(const YarnEnds ends)
    {
      switch (ends)
        {
          case YarnEnds::embedded:
            return "embedded";
          case YarnEnds::gripped:
            return "gripped";
        }
      return nullptr;
    }



    /** Which sides keep the fibers that are bent from sliding along. */
    enum class Grip
    {
      one_side,
      both_sides
    };

    /** How the user names them. */
    constexpr const char *
    word(const Grip grip)
    {
      switch (grip)
        {
          case Grip::one_side:
            return "one side";
          case Grip::both_sides:
            return "both sides";
        }
      return nullptr;
    }



    /** Which fibers end at each side of a fabric, as a support names them:
     * first and last ends of the warp, then of the weft. */
    using FibersAtSides = std::array<std::string, 4>;



    /** A test of a woven sample: the motion of its sides, case by case. */
    class FabricLoadingParameters : public ParameterAcceptor
    {
    public:
      FabricLoadingParameters(const std::string &section = "/Fabric loading");

      /** Whether there is a test. */
      bool
      is_active() const
      {
        return kind != FabricTest::none;
      }

      /** Whether the ends of some yarns are free along them. */
      bool
      leaves_yarns_free() const
      {
        return has_direction() && sides == FreeSides::free;
      }

      bool
      bends() const
      {
        return kind == FabricTest::bending;
      }

      /** To which the fabric is bent, either way; 0 if it is not [1/mm]. */
      double
      largest_curvature() const;

      /** Of all load cases [degrees]; 0 where none shears. */
      double
      largest_shear_angle() const;

      /** A sentence if the strain looks like a percentage, or nothing. */
      std::string
      strain_in_percent() const;

      /** Throw InputError if the entries make no test. */
      void
      check() const;

      /** Of the ramp, see Heddle::turning_points(). */
      std::vector<double>
      turning_points() const;

      /** The load cases in their order; their sides hold the ends of @p fibers
       * and, if there is one, the @p matrix too. */
      std::vector<Contributions::FabricCase>
      cases(const FibersAtSides &fibers, const bool matrix) const;

    private:
      /** Throw InputError if there is no such motion where the ramp is
       * @p reached. */
      void
      check_where_ramp_is(const double reached) const;

      /** How far the ramp gets, either way [-]. */
      double
      largest_ramp() const;

      /** Whether the test pulls along these yarns. */
      bool
      pulls(const YarnSet yarns) const;

      bool
      is_shear() const
      {
        return kind == FabricTest::picture_frame ||
               kind == FabricTest::simple_shear;
      }

      /** Whether it acts along the yarns of one direction only. */
      bool
      has_direction() const
      {
        return kind == FabricTest::uniaxial_tension || bends();
      }

      /** Strain ratios or shear angles; one number without meaning if none. */
      std::vector<double>
      numbers() const;

      /** "biaxial 2": the stage, with the number of its case. */
      std::string
      name(const double number) const;

      Contributions::FabricMotion
      motion(const double number) const;

      Contributions::SupportList
      supports(const Contributions::FabricMotion &motion,
               const FibersAtSides               &fibers,
               const bool                         matrix) const;

      /**
       * Let a support, of yarns that are bent or of others, bend the fabric.
       * Fibers that it @p slides hold may slide along themselves.
       */
      void
      bend(const bool              bent,
           const bool              slides,
           Contributions::Support &support) const;

      Contributions::FabricBending
      bending() const;

      FabricTest          kind          = FabricTest::none;
      double              strain        = 0.02;
      std::vector<double> strain_ratios = {1.};
      YarnSet             direction     = YarnSet::warp;
      FreeSides           sides         = FreeSides::free;
      std::vector<double> shear_angles  = {20.};
      YarnEnds            yarn_ends     = YarnEnds::embedded;
      double              curvature     = 1.;
      Grip                grip          = Grip::one_side;
      SideSections        ends          = SideSections::hinged;
      std::string         ramp          = "t";
    };
  } // namespace Simulation
} // namespace Heddle

#endif
