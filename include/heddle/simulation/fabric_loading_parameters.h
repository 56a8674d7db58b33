#ifndef heddle_simulation_fabric_loading_parameters_h
#define heddle_simulation_fabric_loading_parameters_h

#include <heddle/contributions/fabric_supports.h>

#include <deal.II/base/parameter_acceptor.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace Simulation
  {
    using namespace dealii;

    /** A test of a woven sample: the motion of its sides, case by case. */
    class FabricLoadingParameters : public ParameterAcceptor
    {
    public:
      FabricLoadingParameters(const std::string &section = "/Fabric loading");

      /** Whether there is a test. */
      bool
      is_active() const
      {
        return kind != "none";
      }

      /** Whether the ends of some yarns are free in the plane. */
      bool
      leaves_yarns_free() const
      {
        return kind == "uniaxial tension" && sides == "free";
      }

      /** Of all load cases [degrees]; 0 where none shears. */
      double
      largest_shear_angle() const;

      /** Throw InputError if the entries make no test. */
      void
      check() const;

      /**
       * Load factors between 0 and 1 at which the ramp turns back, or where it
       * begins to stay before it does so, in ascending order.
       */
      std::vector<double>
      turning_points() const;

      /** The load cases in their order; their sides hold @p matrix too. */
      std::vector<Contributions::FabricCase>
      cases(const bool matrix) const;

    private:
      bool
      is_shear() const
      {
        return kind == "picture frame" || kind == "simple shear";
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
               const bool                         matrix) const;

      std::string         kind          = "none";
      double              strain        = 0.02;
      std::vector<double> strain_ratios = {1.};
      std::string         direction     = "warp";
      std::string         sides         = "free";
      std::vector<double> shear_angles  = {20.};
      std::string         ends          = "hinged";
      std::string         ramp          = "t";
    };
  } // namespace Simulation
} // namespace Heddle

#endif
