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
} // namespace Heddle

#endif
