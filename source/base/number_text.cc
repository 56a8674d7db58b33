#include <heddle/base/number_text.h>

#include <iomanip>
#include <sstream>

namespace Heddle
{
  std::string
  number_text(const double value, const unsigned int digits)
  {
    std::ostringstream text;
    text << std::setprecision(digits) << value;
    return text.str();
  }
} // namespace Heddle
