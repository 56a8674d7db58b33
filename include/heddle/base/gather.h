#ifndef heddle_base_gather_h
#define heddle_base_gather_h

#include <mpi.h>

#include <vector>

namespace Heddle
{
  /**
   * Return the numbers of all ranks, those of the first one first, as they are:
   * Utilities::MPI::gather() archives and compresses them.
   * @note Collective.
   */
  std::vector<double>
  gather_on_all(const std::vector<double> &mine, const MPI_Comm communicator);

  /** Likewise, but on other ranks than the first one nothing. */
  std::vector<double>
  gather_on_first(const std::vector<double> &mine, const MPI_Comm communicator);
} // namespace Heddle

#endif
