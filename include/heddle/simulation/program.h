#ifndef heddle_simulation_program_h
#define heddle_simulation_program_h

#include <heddle/simulation/own_contributions.h>

namespace Heddle
{
  namespace Simulation
  {
    /**
     * All that main() does: start MPI and PETSc, read the command line, do what
     * it asks for, and tell what went wrong. Return the exit code. Whoever has
     * contributions of their own (examples/foundation) hands over what makes
     * them; objects of type ParameterAcceptor that exist by then are read from
     * the parameter file, too.
     */
    int
    program(const int argc, char **argv, const OwnContributions &make_own = {});
  } // namespace Simulation
} // namespace Heddle

#endif
