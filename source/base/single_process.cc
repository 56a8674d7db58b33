#include <heddle/base/single_process.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace Heddle
{
  bool
  is_single_process()
  {
    // mpirun, srun by PMIx, srun by PMI 1 or 2, and srun by itself.
    const std::array<const char *, 4> ranks = {
      {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK", "SLURM_PROCID"}};
    return std::none_of(ranks.begin(), ranks.end(), [](const char *rank) {
      return std::getenv(rank) != nullptr;
    });
  }



  void
  spare_daemon_and_networks()
  {
    if (!is_single_process())
      return;
    constexpr int keep = 0;
    // The daemon would start further processes (MPI_Comm_spawn).
    setenv("OMPI_MCA_ess_singleton_isolated", "1", keep);
    // It would also have given each of these processes a folder of its own in
    // /tmp; without it all would make and delete the same one.
    setenv("OMPI_MCA_orte_create_session_dirs", "0", keep);
    setenv("OMPI_MCA_pml", "ob1", keep);
    setenv("OMPI_MCA_btl", "self", keep);
  }
} // namespace Heddle
