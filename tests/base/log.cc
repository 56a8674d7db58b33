// The log says everything once, on rank 0, on the screen and in its file; what
// was said before the file was opened is in there too.
#include <heddle/base/file.h>
#include <heddle/base/log.h>

#include "../tests.h"

#include <iomanip>
#include <sstream>

int
main(int argc, char *argv[])
{
  const MPITest mpi(argc, argv);

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
