// What heddle answers to command lines, all of them in one process: it takes
// longer to start one than to answer. Their arguments come from the standard
// input, one in each line; an empty line ends a command. To the standard output
// go errors and exit codes, with --commands the command lines before them, and
// with --screen what is said to the screen.
#include <heddle/base/command_line.h>
#include <heddle/base/guard.h>
#include <heddle/base/single_process.h>
#include <heddle/simulation/run.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_acceptor.h>

#include <algorithm>
#include <iostream>
#include <new>
#include <sstream>
#include <string>
#include <vector>

using namespace dealii;

/** As after the start of a program: errors leave entries and open sections. */
void
forget_parameters()
{
  ParameterAcceptor::clear();
  ParameterHandler &handler = ParameterAcceptor::prm;
  handler.~ParameterHandler();
  new (&handler) ParameterHandler();
}



int
answer(const std::vector<std::string> &arguments)
{
  forget_parameters();
  return Heddle::guarded(
    [&arguments]() {
      Heddle::Simulation::run(Heddle::parse_command_line(arguments),
                              MPI_COMM_WORLD);
    },
    MPI_COMM_WORLD);
}



int
main(int argc, char *argv[])
{
  const auto is_wanted = [&](const std::string &option) {
    return std::find(argv + 1, argv + argc, option) != argv + argc;
  };
  const bool with_commands = is_wanted("--commands"),
             with_screen   = is_wanted("--screen");
  Heddle::spare_daemon_and_networks();
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  std::ostream       answers(std::cout.rdbuf());
  std::ostringstream screen;
  std::cout.rdbuf(screen.rdbuf());
  std::cerr.rdbuf(answers.rdbuf());

  std::vector<std::string> arguments = {"heddle"};
  for (std::string line; std::getline(std::cin, line);)
    if (!line.empty())
      arguments.push_back(line);
    else
      {
        if (with_commands)
          for (unsigned int i = 1; i < arguments.size(); ++i)
            answers << arguments[i] << (i + 1 < arguments.size() ? ' ' : '\n');
        const int code = answer(arguments);
        if (with_screen)
          answers << screen.str();
        answers << "-> " << code << std::endl;
        screen.str("");
        arguments = {"heddle"};
      }
  std::cout.rdbuf(answers.rdbuf());
}
