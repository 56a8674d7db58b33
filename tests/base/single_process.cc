// A process that nobody launched is spared Open MPI's daemon and networks, but
// for what the environment asks for; ranks of a launcher are left as they are.
#include <heddle/base/single_process.h>

#include "../tests.h"

#include <cstdlib>

std::string
value(const char *name)
{
  const char *text = std::getenv(name);
  return text == nullptr ? "not set" : text;
}



int
main(int argc, char *argv[])
{
  for (const char *name : {"OMPI_MCA_ess_singleton_isolated",
                           "OMPI_MCA_orte_create_session_dirs",
                           "OMPI_MCA_pml",
                           "OMPI_MCA_btl"})
    unsetenv(name);
  setenv("OMPI_MCA_btl", "self,tcp", 1);
  const MPITest mpi(argc, argv);

  deallog << "single: " << Heddle::is_single_process()
          << ", daemon spared: " << value("OMPI_MCA_ess_singleton_isolated")
          << ", folder in /tmp: " << value("OMPI_MCA_orte_create_session_dirs")
          << ", networks: " << value("OMPI_MCA_pml") << " and "
          << value("OMPI_MCA_btl")
          << ", ranks: " << Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD)
          << std::endl;

  for (const char *rank : {"SLURM_PROCID", "PMI_RANK", "PMIX_RANK"})
    {
      const bool was_set = std::getenv(rank) != nullptr;
      setenv(rank, "0", 0);
      deallog << "with " << rank << ": " << Heddle::is_single_process()
              << std::endl;
      if (!was_set)
        unsetenv(rank);
    }
}
