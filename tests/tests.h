#ifndef heddle_tests_tests_h
#define heddle_tests_tests_h

#include <heddle/base/single_process.h>

#include <deal.II/base/logstream.h>
#include <deal.II/base/mpi.h>

#include <fstream>
#include <functional>
#include <iostream>
#include <string>

// Included by tests only, which all are one file and one program.
using namespace dealii;

/** Let deallog write the file that the harness compares. */
inline void
initlog()
{
  static std::ofstream file("output");
  deallog.attach(file, /*print_job_id=*/false);
  deallog.depth_console(0);
  file.precision(6);
}



/**
 * Run a part of a test, below its @p heading. Numbers look alike in all parts.
 */
inline void
run_part(const std::string &heading, const std::function<void()> &part)
{
  deallog << heading << std::endl;
  const std::streamsize digits = deallog.precision(6);
  part();
  deallog.precision(digits);
}



/**
 * Start MPI for a test, and let deallog of rank 0 write the file that the
 * harness compares. To be constructed once, first in main().
 */
class MPITest
{
public:
  MPITest(int &argc, char **&argv)
    : mpi(prepared(argc), argv, /*max_num_threads=*/1)
  {
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      initlog();
    else
      deallog.depth_console(0);
  }

private:
  static int &
  prepared(int &argc)
  {
    Heddle::spare_daemon_and_networks();
    return argc;
  }

  Utilities::MPI::MPI_InitFinalize mpi;
};

#endif
