#ifndef heddle_base_log_h
#define heddle_base_log_h

#include <mpi.h>

#include <fstream>
#include <iosfwd>
#include <sstream>
#include <string>

namespace Heddle
{
  /**
   * What a run says: to the screen, and to a file once there is one. Only rank
   * 0 speaks; the other ranks may write to the log as well, to no effect, so
   * that no caller needs to ask.
   *
   * Text is passed on line by line. What was said before open() is kept and
   * opens the file, so that a run that fails in its input writes nothing.
   */
  class Log
  {
  public:
    /** Write to @p screen, or to the standard output. */
    Log(const MPI_Comm communicator);
    Log(const MPI_Comm communicator, std::ostream &screen);

    /** Leave neither a status line nor half a line behind. */
    ~Log();

    Log(const Log &) = delete;
    Log &
    operator=(const Log &) = delete;

    /**
     * From now on, write to the file @p name as well; with std::ios::app,
     * after what it holds already.
     */
    void
    open(const std::string            &name,
         const std::ios_base::openmode mode = std::ios_base::out);

    /** Append @p value. Manipulators such as std::setw keep their meaning. */
    template <typename T>
    Log &
    operator<<(const T &value);

    /** Append a manipulator such as std::endl. */
    Log &
    operator<<(std::ostream &(*manipulator)(std::ostream &));

    /**
     * Show @p text below the last line until the next line is written. Without
     * effect unless the standard error is a terminal: it never gets into a
     * file.
     */
    void
    status(const std::string &text);

  private:
    void
    pass_on_whole_lines();

    void
    clear_status();

    const bool         speaks;
    const bool         on_terminal;
    std::ostream      &screen;
    std::ofstream      file;
    std::string        said_before_open;
    std::ostringstream pending;
    bool               status_is_shown = false;
  };



  template <typename T>
  Log &
  Log::operator<<(const T &value)
  {
    if (speaks)
      {
        pending << value;
        pass_on_whole_lines();
      }
    return *this;
  }
} // namespace Heddle

#endif
