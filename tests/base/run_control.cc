// What a run says, how long its parts take, what stops it and with which code
// it ends: the same on all ranks.
#include <heddle/base/exceptions.h>
#include <heddle/base/file.h>
#include <heddle/base/guard.h>
#include <heddle/base/log.h>
#include <heddle/base/signals.h>
#include <heddle/base/timer.h>

#include "../tests.h"

#include <chrono>
#include <csignal>
#include <iomanip>
#include <new>
#include <sstream>
#include <thread>

/**
 * The log says everything once, on rank 0, on the screen and in its file; what
 * was said before the file was opened is in there too.
 */
void
log_on_screen_and_in_file()
{
  std::ostringstream screen;
  {
    Heddle::Log log(MPI_COMM_WORLD, screen);
    log << "before " << 1 << std::endl;
    log.open("log.txt");
    log.status("never in a file");
    log << std::scientific << std::setprecision(1) << 0.25 << " and ";
    log << 0.5 << '\n' << std::setw(4) << 7 << " half a line";
  }
  deallog << screen.str() << std::endl;
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    deallog << "file says the same: "
            << (Heddle::read_file("log.txt", "log") == screen.str())
            << std::endl;
  else
    AssertThrow(screen.str().empty(), ExcMessage("Another rank spoke."));
}



void
show(const std::function<void()> &program)
{
  std::ostringstream said;
  std::streambuf    *before = std::cerr.rdbuf(said.rdbuf());
  const int          code   = Heddle::guarded(program, MPI_COMM_WORLD);
  std::cerr.rdbuf(before);

  const unsigned int length =
    Utilities::MPI::sum(said.str().size(), MPI_COMM_WORLD);
  deallog << code << ", least " << Utilities::MPI::min(code, MPI_COMM_WORLD)
          << ", letters said by all " << length << ": " << said.str()
          << std::endl;
}



/**
 * Each kind of exception has its exit code; its text is printed once, whichever
 * rank it came from, and all ranks return the same code.
 */
void
exit_codes()
{
  show([]() {});
  show([]() { throw Heddle::InputError("The input is bad."); });
  show([]() { throw Heddle::NotConverged("Step 3 did not converge."); });
  show([]() { throw Heddle::Stopped("Stopped by signal SIGTERM."); });
  show([]() { throw std::bad_alloc(); });
  show([]() { throw std::runtime_error("Something broke."); });
  show([]() { throw 3; });
  show([]() {
    const auto rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    Heddle::require(rank > 0, "Rank 0 alone is not happy.");
  });
}



/**
 * Times of a section add up over its visits, and the inner section counts for
 * the outer one as well.
 */
void
section_times()
{
  Heddle::SectionTimer timer;
  for (unsigned int i = 0; i < 3; ++i)
    {
      const Heddle::SectionTimer::Scope outer(timer, "contact");
      const Heddle::SectionTimer::Scope inner(timer, "broad phase");
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  for (const auto &section : timer.all_sections())
    deallog << section.name << ": visits " << section.visits
            << ", at least 60 ms " << (section.seconds >= 0.06) << std::endl;
  deallog << "outer not less than inner "
          << (timer.seconds("contact") >= timer.seconds("broad phase"))
          << ", total not less than outer "
          << (timer.total() >= timer.seconds("contact")) << ", never visited "
          << timer.seconds("friction") << std::endl;

  const std::string table = timer.table();
  deallog << "lines " << std::count(table.begin(), table.end(), '\n')
          << ", names the inner one "
          << (table.find("  broad phase") != std::string::npos) << std::endl;
}



/**
 * A signal that reaches one rank, or the limit of time, stops all ranks; one
 * that is ignored, as SIGHUP is under nohup, stops none.
 */
void
stop_requests()
{
  const int last = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) - 1;
  const int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);

  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1})
    {
      Heddle::StopRequest stop(MPI_COMM_WORLD);
      stop.catch_signals();
      const bool before = stop.received();
      if (rank == last)
        std::raise(signal);
      const bool after = stop.received();
      deallog << before << " -> " << after << ": " << stop.reason()
              << std::endl;
    }

  std::signal(SIGHUP, SIG_IGN);
  Heddle::StopRequest stop(MPI_COMM_WORLD);
  stop.catch_signals();
  std::raise(SIGHUP);
  deallog << stop.received() << ": " << stop.reason() << std::endl;
  stop.set_limit(0.05);
  const bool before = stop.received();
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  const bool after = stop.received();
  deallog << before << " -> " << after << ": " << stop.reason() << std::endl;
}



int
main(int argc, char **argv)
{
  const MPITest mpi(argc, argv);
  run_part("Log", log_on_screen_and_in_file);
  run_part("Exceptions and exit codes", exit_codes);
  run_part("Times of sections", section_times);
  run_part("Requests to stop", stop_requests);
}
