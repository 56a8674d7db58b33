#ifndef heddle_base_exceptions_h
#define heddle_base_exceptions_h

#include <stdexcept>
#include <string>

namespace Heddle
{
  /**
   * Something that the user can mend: a wrong parameter, a geometry that
   * cannot be read, a combination that has no meaning. What it says is one
   * sentence with the value that was found and the remedy.
   */
  class InputError : public std::runtime_error
  {
  public:
    explicit InputError(const std::string &what)
      : std::runtime_error(what)
    {
    }
  };
} // namespace Heddle

#endif
