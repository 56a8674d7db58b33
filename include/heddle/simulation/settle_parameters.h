#ifndef heddle_simulation_settle_parameters_h
#define heddle_simulation_settle_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace Simulation
  {
    using namespace dealii;

    /** How the initial configuration of a weave is computed. */
    class SettleParameters : public ParameterAcceptor
    {
    public:
      SettleParameters(const std::string &section = "/Initial configuration");

      /** The thresholds in the order in which they are settled. */
      std::vector<double>
      thresholds(const double contact_threshold) const;

      /** The strain that the force on the ends of a fiber of @p set would make
       * [-]. */
      double
      tension_of(const std::string &set) const;

      double guide_stiffness = 0.1;
      bool   friction        = true;

    private:
      double              axial_tension = 0.006;
      double              weft_tension  = 0.;
      std::vector<double> listed_thresholds;
    };
  } // namespace Simulation
} // namespace Heddle

#endif
