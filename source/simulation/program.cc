#include <heddle/base/command_line.h>
#include <heddle/base/guard.h>
#include <heddle/base/log.h>
#include <heddle/base/single_process.h>
#include <heddle/simulation/program.h>
#include <heddle/simulation/run.h>

#include <deal.II/base/mpi.h>

#include <cstdlib>
#include <string>
#include <vector>

/** Of OpenBLAS, where that is what provides BLAS. */
extern "C" void
openblas_set_num_threads(int n_threads) __attribute__((weak));

namespace Heddle
{
  namespace Simulation
  {
    int
    program(const int argc, char **argv, const OwnContributions &make_own)
    {
      // The ranks are the parallelism: threads of BLAS would wait for work in
      // the time of other ranks.
      if (openblas_set_num_threads != nullptr &&
          std::getenv("OPENBLAS_NUM_THREADS") == nullptr)
        openblas_set_num_threads(1);
      spare_daemon_and_networks();

      std::vector<std::string> arguments(argv, argv + argc);
      std::vector<std::string> petsc = take_petsc_arguments(arguments);
      std::vector<char *>      petsc_argv;
      for (std::string &argument : petsc)
        petsc_argv.push_back(argument.data());
      petsc_argv.push_back(nullptr);
      int    petsc_argc   = petsc.size();
      char **petsc_values = petsc_argv.data();

      const Utilities::MPI::MPI_InitFinalize mpi(petsc_argc,
                                                 petsc_values,
                                                 /*max_num_threads=*/1);

      // What a scene owns is gone before MPI and PETSc are.
      return guarded(
        [&]() {
          const CommandLine command_line = parse_command_line(arguments);
          if (command_line.task == CommandLine::Task::print_text)
            Log(MPI_COMM_WORLD) << command_line.text << std::flush;
          else
            run(command_line, MPI_COMM_WORLD, make_own);
        },
        MPI_COMM_WORLD);
    }
  } // namespace Simulation
} // namespace Heddle
