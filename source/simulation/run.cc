#include <heddle/base/log.h>
#include <heddle/base/parameter_file.h>
#include <heddle/simulation/run.h>

namespace Heddle
{
  namespace Simulation
  {
    void
    run(const CommandLine &command_line, const MPI_Comm communicator)
    {
      Log           log(communicator);
      ParameterFile file(command_line.parameter_file);
      for (const std::string &assignment : command_line.assignments)
        file.set(assignment);
      file.apply();
      log << "Parameters from " << file.name() << std::endl;
    }
  } // namespace Simulation
} // namespace Heddle
