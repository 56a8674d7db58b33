#ifndef heddle_base_guard_h
#define heddle_base_guard_h

#include <mpi.h>

#include <functional>

namespace Heddle
{
  /**
   * Run @p program and return the exit code that answers to how it ended: 0 if
   * it returned, 2 after InputError, 3 after NotConverged, 4 after Stopped and
   * 1 after any other exception. The message goes to the standard error, once.
   *
   * When the other ranks do not get here within @p patience seconds, the error
   * is one of this rank alone: it says so itself, and all ranks are ended.
   *
   * @note Collective.
   */
  int
  guarded(const std::function<void()> &program,
          const MPI_Comm               communicator,
          const double                 patience = 5.);
} // namespace Heddle

#endif
