#ifndef heddle_simulation_run_parameters_h
#define heddle_simulation_run_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <string>

namespace Heddle
{
  namespace Simulation
  {
    using namespace dealii;

    /** What is computed, and where it goes. */
    class RunParameters : public ParameterAcceptor
    {
    public:
      RunParameters(const std::string &section = "/Run");

      std::string scene            = "weave";
      std::string output_directory = "";
      bool        timing           = true;
      double      wall_time_limit  = 0.;
    };
  } // namespace Simulation
} // namespace Heddle

#endif
