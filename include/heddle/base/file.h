#ifndef heddle_base_file_h
#define heddle_base_file_h

#include <mpi.h>

#include <string>

namespace Heddle
{
  /**
   * Return the whole text of the file @p name. Throw InputError if there is no
   * such file, or if it cannot be read; @p what says what the file was wanted
   * for, as in "parameter file".
   */
  std::string
  read_file(const std::string &name, const std::string &what);

  /**
   * The same by the first rank for all, which get the same text, or throw
   * together.
   * @note Collective.
   */
  std::string
  read_file(const std::string &name,
            const std::string &what,
            const MPI_Comm     communicator);

  /**
   * Write @p text to the file @p name: first beside it, then renamed, so that
   * whoever reads finds either the old text or the new one, never a part.
   */
  void
  write_file(const std::string &name, const std::string &text);

  /**
   * Create the folder @p name and those above it, unless they are there. Throw
   * InputError if that is not possible or if the folder cannot be written to.
   */
  void
  create_folder(const std::string &name);

  /**
   * Return @p name as seen from the folder of the file @p from: a relative
   * path inside a file is meant relative to that file.
   */
  std::string
  relative_to(const std::string &from, const std::string &name);
} // namespace Heddle

#endif
