// Each kind of exception has its exit code; its text is printed once, whichever
// rank it came from, and all ranks return the same code.
#include <heddle/base/exceptions.h>
#include <heddle/base/guard.h>

#include "../tests.h"

#include <new>
#include <sstream>

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



int
main(int argc, char *argv[])
{
  const MPITest mpi(argc, argv);
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
