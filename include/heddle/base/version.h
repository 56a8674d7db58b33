#ifndef heddle_base_version_h
#define heddle_base_version_h

#include <string>

namespace Heddle
{
  /** Return the version of heddle, as in "0.1.0". */
  std::string
  version();

  /** Return "Debug" or "Release". */
  std::string
  build_type();

  /**
   * Return the commit of the sources, abbreviated, with what was not committed
   * left unsaid; empty if they did not lie in a clone.
   */
  std::string
  revision();

  /**
   * Return one line each for heddle and for the libraries that it stands on,
   * with their versions.
   */
  std::string
  version_text();
} // namespace Heddle

#endif
