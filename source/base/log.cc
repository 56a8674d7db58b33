#include <heddle/base/exceptions.h>
#include <heddle/base/log.h>

#include <unistd.h>

#include <iostream>

namespace Heddle
{
  namespace internal
  {
    namespace Log
    {
      bool
      is_first_rank(const MPI_Comm communicator)
      {
        int rank;
        MPI_Comm_rank(communicator, &rank);
        return rank == 0;
      }
    } // namespace Log
  }   // namespace internal



  Log::Log(const MPI_Comm communicator)
    : Log(communicator, std::cout)
  {
  }



  Log::Log(const MPI_Comm communicator, std::ostream &screen)
    : speaks(internal::Log::is_first_rank(communicator))
    , on_terminal(speaks && isatty(STDERR_FILENO))
    , screen(screen)
  {
  }



  Log::~Log()
  {
    clear_status();
    if (!pending.str().empty())
      *this << std::endl;
  }



  void
  Log::open(const std::string &name, const std::ios_base::openmode mode)
  {
    if (!speaks)
      return;
    file.open(name, mode);
    require(file.good(), "The log \"" + name + "\" cannot be written.");
    file << said_before_open << std::flush;
    said_before_open.clear();
  }



  Log &
  Log::operator<<(std::ostream &(*manipulator)(std::ostream &))
  {
    if (speaks)
      {
        pending << manipulator;
        pass_on_whole_lines();
      }
    return *this;
  }



  void
  Log::status(const std::string &text)
  {
    if (!on_terminal)
      return;
    clear_status();
    std::cerr << text << std::flush;
    status_is_shown = true;
  }



  void
  Log::pass_on_whole_lines()
  {
    const std::string text = pending.str();
    const auto        end  = text.rfind('\n');
    if (end == std::string::npos)
      return;

    const std::string lines = text.substr(0, end + 1);
    clear_status();
    screen << lines << std::flush;
    if (file.is_open())
      file << lines << std::flush;
    else
      said_before_open += lines;

    // Only the text is replaced: precision and notation stay.
    pending.str(text.substr(end + 1));
    pending.seekp(0, std::ios::end);
  }



  void
  Log::clear_status()
  {
    if (status_is_shown)
      std::cerr << "\r\033[K" << std::flush;
    status_is_shown = false;
  }
} // namespace Heddle
