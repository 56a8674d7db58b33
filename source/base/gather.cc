#include <heddle/base/gather.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <numeric>

namespace Heddle
{
  using namespace dealii;

  namespace
  {
    /** How many numbers each rank has, and where they are to be. */
    struct Layout
    {
      Layout(const std::size_t n_mine, const MPI_Comm communicator)
        : sizes(Utilities::MPI::n_mpi_processes(communicator))
        , begins(sizes.size(), 0)
      {
        const int mine = n_mine;
        const int ierr = MPI_Allgather(
          &mine, 1, MPI_INT, sizes.data(), 1, MPI_INT, communicator);
        AssertThrowMPI(ierr);
        std::partial_sum(sizes.begin(), sizes.end() - 1, begins.begin() + 1);
      }

      std::size_t
      n_all() const
      {
        return begins.back() + sizes.back();
      }

      std::vector<int> sizes, begins;
    };
  } // namespace



  std::vector<double>
  gather_on_all(const std::vector<double> &mine, const MPI_Comm communicator)
  {
    if (Utilities::MPI::n_mpi_processes(communicator) == 1)
      return mine;
    const Layout        layout(mine.size(), communicator);
    std::vector<double> all(layout.n_all());
    const int           ierr = MPI_Allgatherv(mine.data(),
                                    mine.size(),
                                    MPI_DOUBLE,
                                    all.data(),
                                    layout.sizes.data(),
                                    layout.begins.data(),
                                    MPI_DOUBLE,
                                    communicator);
    AssertThrowMPI(ierr);
    return all;
  }



  std::vector<double>
  gather_on_first(const std::vector<double> &mine, const MPI_Comm communicator)
  {
    if (Utilities::MPI::n_mpi_processes(communicator) == 1)
      return mine;
    const Layout        layout(mine.size(), communicator);
    std::vector<double> all;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      all.resize(layout.n_all());
    const int ierr = MPI_Gatherv(mine.data(),
                                 mine.size(),
                                 MPI_DOUBLE,
                                 all.data(),
                                 layout.sizes.data(),
                                 layout.begins.data(),
                                 MPI_DOUBLE,
                                 0,
                                 communicator);
    AssertThrowMPI(ierr);
    return all;
  }
} // namespace Heddle
