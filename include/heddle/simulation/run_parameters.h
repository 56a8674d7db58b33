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

      /** Whether fibers come from a file, and not from a weave. */
      bool
      is_from_file() const
      {
        return scene != "weave";
      }

      /** Whether there are warp and weft, which settle before a load. */
      bool
      is_fabric() const
      {
        return scene != "centerlines";
      }

      std::string scene            = "weave";
      std::string output_directory = "";
      bool        timing           = true;
      double      wall_time_limit  = 0.;
    };
  } // namespace Simulation
} // namespace Heddle

#endif
