#ifndef heddle_base_throw_together_h
#define heddle_base_throw_together_h

#include <deal.II/base/mpi.h>

#include <functional>
#include <type_traits>

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
   * Return on all ranks what @p question, which looks at files, answers the
   * first one: on disks of a network others may see them as they were. If it
   * throws an InputError all of them throw the same.
   * @note Collective, but for what @p question does.
   */
  template <typename Question>
  std::invoke_result_t<Question>
  ask_first_rank(const Question &question, const MPI_Comm communicator)
  {
    using namespace dealii;
    std::invoke_result_t<Question> answer{};
    throw_together(
      [&]() {
        if (Utilities::MPI::this_mpi_process(communicator) == 0)
          answer = question();
      },
      communicator);
    return Utilities::MPI::broadcast(communicator, answer);
  }

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
