#include <heddle/base/exceptions.h>
#include <heddle/base/throw_together.h>

#include <deal.II/base/mpi.h>

#include <string>

namespace Heddle
{
  using namespace dealii;

  void
  throw_together(const std::function<void()> &action, MPI_Comm communicator)
  {
    const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    std::string        fault;
    try
      {
        action();
      }
    catch (const InputError &error)
      {
        fault = error.what();
      }
    const unsigned int first =
      Utilities::MPI::min(fault.empty() ? n_ranks : rank, communicator);
    if (first < n_ranks)
      throw InputError(Utilities::MPI::broadcast(communicator, fault, first));
  }
} // namespace Heddle
