#include <heddle/base/text_lines.h>

namespace Heddle
{
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
    return "";
  }
} // namespace Heddle
