#ifndef heddle_base_reduce_h
#define heddle_base_reduce_h

#include <mpi.h>

#include <array>

namespace Heddle
{
  /** Replace @p values by their sums over all ranks. @note Collective. */
  template <std::size_t N>
  void
  sum_over_ranks(std::array<double, N> &values, const MPI_Comm communicator)
  {
    MPI_Allreduce(
      MPI_IN_PLACE, values.data(), N, MPI_DOUBLE, MPI_SUM, communicator);
  }



  /** Replace @p values by the largest over all ranks. @note Collective. */
  template <std::size_t N>
  void
  max_over_ranks(std::array<double, N> &values, const MPI_Comm communicator)
  {
    MPI_Allreduce(
      MPI_IN_PLACE, values.data(), N, MPI_DOUBLE, MPI_MAX, communicator);
  }
} // namespace Heddle

#endif
