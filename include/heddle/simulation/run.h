#ifndef heddle_simulation_run_h
#define heddle_simulation_run_h

#include <heddle/base/command_line.h>
#include <heddle/simulation/own_contributions.h>

#include <mpi.h>

namespace Heddle
{
  namespace Simulation
  {
    /**
     * Do what the command line asks for: compute the scene, check it, or print
     * its parameters. How it failed is told by the type of the exception.
     * Contributions that @p make_own makes act in stages with loads.
     *
     * @note Collective.
     */
    void
    run(const CommandLine      &command_line,
        const MPI_Comm          communicator,
        const OwnContributions &make_own = {});
  } // namespace Simulation
} // namespace Heddle

#endif
