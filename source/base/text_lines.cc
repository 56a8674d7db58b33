#include <heddle/base/text_lines.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace Heddle
{
  namespace
  {
    bool
    is_ascii(const unsigned char letter)
    {
      return letter < 128;
    }
  } // namespace



  bool
  take_line(std::istream &input, std::string &line)
  {
    line.clear();
    for (char letter; input.get(letter);)
      {
        if (letter == '\r' && input.peek() == '\n')
          continue;
        if (letter == '\n' || letter == '\r')
          return true;
        line += letter;
      }
    return !line.empty();
  }



  std::string
  no_text(const std::string &line)
  {
    const std::string start = line.substr(0, 2);
    if (line.find('\0') != std::string::npos || start == "\xFF\xFE" ||
        start == "\xFE\xFF")
      return "there are bytes of no text, as in UTF-16 or in a spreadsheet";
    if (std::all_of(line.begin(), line.end(), is_ascii))
      return "";
    // As summary.json would have it, if it could be written.
    using Json             = nlohmann::json;
    const Json        text = line;
    const std::string shown =
      text.dump(-1, ' ', false, Json::error_handler_t::replace);
    return shown == text.dump(-1, ' ', false, Json::error_handler_t::ignore)
             ? ""
             : shown + " is not in UTF-8";
  }
} // namespace Heddle
