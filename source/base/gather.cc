#include <heddle/base/gather.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <numeric>

namespace Heddle
{
  using namespace dealii;

  namespace
  {
    /** On all ranks, or on the first one alone. */
    std::vector<double>
    gather(const std::vector<double> &mine,
           const MPI_Comm             communicator,
           const bool                 on_all)
    {
      const unsigned int n_ranks =
        Utilities::MPI::n_mpi_processes(communicator);
      if (n_ranks == 1)
        return mine;
      const int        n_mine = mine.size();
      std::vector<int> sizes(n_ranks), begins(n_ranks, 0);
      int              ierr = MPI_Allgather(
        &n_mine, 1, MPI_INT, sizes.data(), 1, MPI_INT, communicator);
      AssertThrowMPI(ierr);
      std::partial_sum(sizes.begin(), sizes.end() - 1, begins.begin() + 1);

      std::vector<double> all;
      if (on_all || Utilities::MPI::this_mpi_process(communicator) == 0)
        all.resize(begins.back() + sizes.back());
      const auto call = [&](const auto &function, const auto... where) {
        return function(mine.data(),
                        n_mine,
                        MPI_DOUBLE,
                        all.data(),
                        sizes.data(),
                        begins.data(),
                        MPI_DOUBLE,
                        where...);
      };
      ierr = on_all ? call(MPI_Allgatherv, communicator)
                    : call(MPI_Gatherv, /*root=*/0, communicator);
      AssertThrowMPI(ierr);
      return all;
    }
  } // namespace



  std::vector<double>
  gather_on_all(const std::vector<double> &mine, const MPI_Comm communicator)
  {
    return gather(mine, communicator, /*on_all=*/true);
  }



  std::vector<double>
  gather_on_first(const std::vector<double> &mine, const MPI_Comm communicator)
  {
    return gather(mine, communicator, /*on_all=*/false);
  }
} // namespace Heddle
