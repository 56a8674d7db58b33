// A signal that reaches one rank, or the limit of time, stops all ranks; one
// that is ignored, as SIGHUP is under nohup, stops none.
#include <heddle/base/signals.h>

#include "../tests.h"

#include <chrono>
#include <csignal>
#include <thread>

int
main(int argc, char *argv[])
{
  const MPITest mpi(argc, argv);
  const int     last = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) - 1;
  const int     rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);

  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1})
    {
      Heddle::StopRequest stop(MPI_COMM_WORLD);
      const bool          before = stop.received();
      if (rank == last)
        std::raise(signal);
      const bool after = stop.received();
      deallog << before << " -> " << after << ": " << stop.reason()
              << std::endl;
    }

  std::signal(SIGHUP, SIG_IGN);
  Heddle::StopRequest stop(MPI_COMM_WORLD);
  std::raise(SIGHUP);
  deallog << stop.received() << ": " << stop.reason() << std::endl;
  stop.set_limit(0.05);
  const bool before = stop.received();
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  const bool after = stop.received();
  deallog << before << " -> " << after << ": " << stop.reason() << std::endl;
}
