// Every option arrives; mistakes are answered by one sentence; what follows
// --petsc is left to PETSc.
#include <heddle/base/command_line.h>
#include <heddle/base/exceptions.h>

#include "../tests.h"

void
show(std::vector<std::string> arguments)
{
  using Heddle::CommandLine;
  arguments.insert(arguments.begin(), "heddle");
  const auto petsc = Heddle::take_petsc_arguments(arguments);
  try
    {
      const CommandLine line = Heddle::parse_command_line(arguments);
      deallog << (line.task == CommandLine::Task::run        ? "run"
                  : line.task == CommandLine::Task::validate ? "validate"
                  : line.task == CommandLine::Task::print_parameters
                    ? "parameters"
                    : "text")
              << " \"" << line.parameter_file << "\" into \""
              << line.output_directory << "\"" << (line.resume ? " again" : "");
      for (const std::string &assignment : line.assignments)
        deallog << ", set " << assignment;
      for (unsigned int i = 1; i < petsc.size(); ++i)
        deallog << ", petsc " << petsc[i];
      deallog << std::endl;
    }
  catch (const Heddle::InputError &error)
    {
      deallog << error.what() << std::endl;
    }
}



int
main()
{
  initlog();
  show({"a.prm"});
  show({"--validate", "a.prm"});
  show({"a.prm", "--print-parameters"});
  show({"--print-parameters"});
  show({"--help"});
  show({"--version"});
  show({"--set", "A/B=1", "a.prm", "--set", "C d/E=x, y"});
  show({"--set=A/B=1", "--output-directory", "there", "--resume", "a.prm"});
  show({"a.prm", "--petsc", "-log_view", "--set"});
  show({});
  show({"--resume"});
  show({"a.prm", "b.prm"});
  show({"a.prm", "--fast"});
  show({"a.prm", "--set"});
  show({"a.prm", "--validate", "--print-parameters"});
}
