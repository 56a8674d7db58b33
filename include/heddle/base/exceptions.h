#ifndef heddle_base_exceptions_h
#define heddle_base_exceptions_h

#include <stdexcept>
#include <string>

namespace Heddle
{
  /**
   * The user asked for something that cannot be. The message is one sentence:
   * where, what was found, what is allowed, what to do.
   */
  class InputError : public std::runtime_error
  {
  public:
    explicit InputError(const std::string &message)
      : std::runtime_error(message)
    {
    }
  };
} // namespace Heddle

#endif
