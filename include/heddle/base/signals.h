#ifndef heddle_base_signals_h
#define heddle_base_signals_h

#include <mpi.h>

#include <chrono>
#include <csignal>
#include <string>
#include <vector>

namespace Heddle
{
  /**
   * Whether the run was asked to stop: by one of the signals SIGINT, SIGTERM,
   * SIGHUP and SIGUSR1, unless it was ignored before, or by a limit on its
   * wall-clock time. The run asks between two iterations, saves its state and
   * ends in order.
   *
   * A second SIGINT, SIGTERM or SIGHUP ends the program at once.
   */
  class StopRequest
  {
  public:
    /** There is one such object at a time. */
    StopRequest(const MPI_Comm communicator);

    /** Signals are requests from now on, and do not end the program. */
    void
    catch_signals();

    /** Signals do again what they did before. */
    ~StopRequest();

    StopRequest(const StopRequest &) = delete;
    StopRequest &
    operator=(const StopRequest &) = delete;

    /** Stop @p seconds after construction of this object; 0 means no limit. */
    void
    set_limit(const double seconds);

    /**
     * Return whether any rank was asked to stop. All ranks get one answer.
     *
     * @note Collective.
     */
    bool
    received();

    /** Return what the request was, as in "signal SIGTERM". */
    std::string
    reason() const;

  private:
    const MPI_Comm                              communicator;
    const std::chrono::steady_clock::time_point start;
    double                                      limit = 0.;
    int                                         cause = 0;
    std::vector<struct sigaction>               previous;
  };
} // namespace Heddle

#endif
