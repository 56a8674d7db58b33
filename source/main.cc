#include <heddle/simulation/program.h>

int
main(int argc, char *argv[])
{
  return Heddle::Simulation::program(argc, argv);
}
