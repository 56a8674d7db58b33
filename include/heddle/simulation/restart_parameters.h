#ifndef heddle_simulation_restart_parameters_h
#define heddle_simulation_restart_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <string>

namespace Heddle
{
  namespace Simulation
  {
    using namespace dealii;

    /** How loading begins in the initial configuration of a weave. */
    class RestartParameters : public ParameterAcceptor
    {
    public:
      RestartParameters(const std::string &section = "/Restart");

      std::string initial_configuration;
      bool        stress_free = false;
    };
  } // namespace Simulation
} // namespace Heddle

#endif
