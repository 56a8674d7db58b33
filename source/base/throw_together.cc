#include <heddle/base/exceptions.h>
#include <heddle/base/throw_together.h>

#include <deal.II/base/mpi.h>

#include <stdexcept>
#include <string>

namespace Heddle
{
  using namespace dealii;

  namespace internal
  {
    namespace ThrowTogether
    {
      /** All throw the @p Error that the first one has caught, if any has. */
      template <typename Error>
      void
      run(const std::function<void()> &action, const MPI_Comm communicator)
      {
        const unsigned int rank =
          Utilities::MPI::this_mpi_process(communicator);
        const unsigned int n_ranks =
          Utilities::MPI::n_mpi_processes(communicator);
        std::string fault;
        try
          {
            action();
          }
        catch (const Error &error)
          {
            fault = error.what();
          }
        const unsigned int first =
          Utilities::MPI::min(fault.empty() ? n_ranks : rank, communicator);
        if (first < n_ranks)
          throw Error(Utilities::MPI::broadcast(communicator, fault, first));
      }
    } // namespace ThrowTogether
  }   // namespace internal



  void
  throw_together(const std::function<void()> &action, MPI_Comm communicator)
  {
    internal::ThrowTogether::run<InputError>(action, communicator);
  }



  void
  write_together(const std::function<void()> &action, MPI_Comm communicator)
  {
    const auto on_first_rank = [&]() {
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        action();
    };
    internal::ThrowTogether::run<std::runtime_error>(on_first_rank,
                                                     communicator);
  }
} // namespace Heddle
