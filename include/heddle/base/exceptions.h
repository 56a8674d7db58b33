#ifndef heddle_base_exceptions_h
#define heddle_base_exceptions_h

#include <stdexcept>
#include <string>

namespace Heddle
{
  /**
   * The input is at fault: a file that does not exist, a value that cannot be
   * used, an impossible combination. The text is one sentence that says where,
   * what was found and what to do. The program ends with exit code 2.
   */
  class InputError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };



  /**
   * No equilibrium was found, and smaller steps did not help. The last good
   * state was kept. The program ends with exit code 3.
   */
  class NotConverged : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };



  /**
   * The run was stopped by a signal or by a limit that the user had set, after
   * its state was saved. The program ends with exit code 4.
   */
  class Stopped : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };



  /**
   * Throw InputError with @p message unless @p condition holds. For what the
   * user can cause; what only we can cause is caught by Assert.
   * The message is put together whether the condition holds or not.
   */
  inline void
  require(const bool condition, const std::string &message)
  {
    if (!condition)
      throw InputError(message);
  }
} // namespace Heddle

#endif
