#ifndef heddle_base_file_h
#define heddle_base_file_h

#include <string>

namespace Heddle
{
  /**
   * Replace the file @p path by @p content. The content is written beside it
   * and renamed, so that whoever reads, or a run that is killed, finds either
   * the old file or the new one. Missing folders are made.
   */
  void
  write_file(const std::string &path, const std::string &content);
} // namespace Heddle

#endif
