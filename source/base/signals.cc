#include <heddle/base/signals.h>

#include <array>
#include <csignal>

namespace Heddle
{
  namespace internal
  {
    namespace StopRequest
    {
      constexpr int limit_reached = 1000;

      constexpr std::array<int, 4> signals = {
        {SIGINT, SIGTERM, SIGHUP, SIGUSR1}};

      volatile std::sig_atomic_t last_signal = 0;



      extern "C" void
      heddle_note_signal(const int signal)
      {
        last_signal = signal;
        // The next one of its kind ends the program.
        if (signal != SIGUSR1)
          std::signal(signal, SIG_DFL);
      }
    } // namespace StopRequest
  }   // namespace internal



  StopRequest::StopRequest(const MPI_Comm communicator)
    : communicator(communicator)
    , start(std::chrono::steady_clock::now())
  {
  }



  void
  StopRequest::catch_signals()
  {
    internal::StopRequest::last_signal = 0;
    for (const int signal : internal::StopRequest::signals)
      {
        struct sigaction before = {};
        sigaction(signal, nullptr, &before);
        previous.push_back(before);
        // Such as SIGHUP under nohup: who started the run wants it so.
        if (before.sa_handler == SIG_IGN)
          continue;
        struct sigaction action = {};
        action.sa_handler       = internal::StopRequest::heddle_note_signal;
        action.sa_flags         = SA_RESTART;
        sigaction(signal, &action, nullptr);
      }
  }



  StopRequest::~StopRequest()
  {
    // None, unless they were caught.
    for (unsigned int i = 0; i < previous.size(); ++i)
      sigaction(internal::StopRequest::signals[i], &previous[i], nullptr);
  }



  void
  StopRequest::set_limit(const double seconds)
  {
    limit = seconds;
  }



  bool
  StopRequest::received()
  {
    const std::chrono::duration<double> elapsed =
      std::chrono::steady_clock::now() - start;
    int mine = internal::StopRequest::last_signal;
    if (mine == 0 && limit > 0. && elapsed.count() > limit)
      mine = internal::StopRequest::limit_reached;

    MPI_Allreduce(&mine, &cause, 1, MPI_INT, MPI_MAX, communicator);
    return cause != 0;
  }



  std::string
  StopRequest::reason() const
  {
    switch (cause)
      {
        case 0:
          return "no request";
        case SIGINT:
          return "signal SIGINT";
        case SIGTERM:
          return "signal SIGTERM";
        case SIGHUP:
          return "signal SIGHUP";
        case SIGUSR1:
          return "signal SIGUSR1";
        default:
          return "the wall-clock limit";
      }
  }
} // namespace Heddle
