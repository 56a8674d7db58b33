#include <heddle/base/exceptions.h>
#include <heddle/base/guard.h>

#include <chrono>
#include <exception>
#include <iostream>
#include <limits>
#include <new>
#include <string>
#include <thread>

namespace Heddle
{
  namespace internal
  {
    namespace Guard
    {
      /** How a program ended: exit code and what there is to say about it. */
      struct End
      {
        int         code = 0;
        std::string message;
      };



      End
      run(const std::function<void()> &program)
      {
        try
          {
            program();
            return {};
          }
        catch (const InputError &error)
          {
            return {2, error.what()};
          }
        catch (const NotConverged &error)
          {
            return {3, error.what()};
          }
        catch (const Stopped &error)
          {
            return {4, error.what()};
          }
        catch (const std::bad_alloc &)
          {
            return {1, "The memory of this machine does not suffice."};
          }
        catch (const std::exception &error)
          {
            return {1, error.what()};
          }
        catch (...)
          {
            return {1, "An exception of unknown type was thrown."};
          }
      }



      /**
       * Wait until all ranks call this function, for @p patience seconds at
       * most. Return whether they did.
       */
      bool
      all_arrive(const MPI_Comm communicator, const double patience)
      {
        using Clock       = std::chrono::steady_clock;
        const auto  start = Clock::now();
        MPI_Request request;
        MPI_Ibarrier(communicator, &request);

        int arrived = 0;
        MPI_Test(&request, &arrived, MPI_STATUS_IGNORE);
        while (!arrived &&
               std::chrono::duration<double>(Clock::now() - start).count() <
                 patience)
          {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
            MPI_Test(&request, &arrived, MPI_STATUS_IGNORE);
          }
        return arrived;
      }



      /** The pair of integers that MPI_MINLOC works on. */
      struct CodeOfRank
      {
        int code;
        int rank;
      };
    } // namespace Guard
  }   // namespace internal



  int
  guarded(const std::function<void()> &program,
          const MPI_Comm               communicator,
          const double                 patience)
  {
    // The ranks meet on a communicator of their own: a rank that failed must
    // not be mistaken for one that takes part in the others' communication.
    MPI_Comm meeting;
    MPI_Comm_dup(communicator, &meeting);
    int rank;
    MPI_Comm_rank(meeting, &rank);

    const internal::Guard::End end = internal::Guard::run(program);

    // Who succeeded waits for the others, however long they take.
    const double wait =
      end.code == 0 ? std::numeric_limits<double>::infinity() : patience;
    if (!internal::Guard::all_arrive(meeting, wait))
      {
        std::cerr << "heddle: error on rank " << rank << ": " << end.message
                  << std::endl;
        MPI_Abort(communicator, end.code);
      }

    // The largest code counts, and the lowest rank that has it speaks for all.
    const internal::Guard::CodeOfRank mine = {-end.code, rank};
    internal::Guard::CodeOfRank       first;
    MPI_Allreduce(&mine, &first, 1, MPI_2INT, MPI_MINLOC, meeting);
    if (first.code != 0 && first.rank == rank)
      std::cerr << "heddle: " << (end.code == 4 ? "" : "error: ") << end.message
                << std::endl;
    MPI_Comm_free(&meeting);
    return -first.code;
  }
} // namespace Heddle
