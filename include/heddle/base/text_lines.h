#ifndef heddle_base_text_lines_h
#define heddle_base_text_lines_h

#include <istream>
#include <string>

namespace Heddle
{
  /**
   * Take the next line of @p input, whether lines end as on Unix, Windows or
   * old Macs. Return false at the end.
   */
  bool
  take_line(std::istream &input, std::string &line);

  /**
   * Return what keeps a @p line from being text in UTF-8, as the beginning of a
   * sentence; nothing if it is.
   */
  std::string
  no_text(const std::string &line);
} // namespace Heddle

#endif
