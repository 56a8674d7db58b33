#ifndef heddle_base_throw_together_h
#define heddle_base_throw_together_h

#include <mpi.h>

#include <functional>

namespace Heddle
{
  /**
   * Call @p action, which finds a fault of the input on some ranks only, as in
   * a formula that is evaluated where each rank has nodes. If any rank throws
   * an InputError, all of them throw that of the first such rank.
   * @note Collective, but for what @p action does.
   */
  void
  throw_together(const std::function<void()> &action, MPI_Comm communicator);

  /**
   * Let the first rank call @p action, which changes files of a run that is
   * under way, and wait for it. If it fails all ranks throw what it said as a
   * std::runtime_error: a disk that is full is no fault of the input.
   * @note Collective.
   */
  void
  write_together(const std::function<void()> &action, MPI_Comm communicator);
} // namespace Heddle

#endif
