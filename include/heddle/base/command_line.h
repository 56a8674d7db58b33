#ifndef heddle_base_command_line_h
#define heddle_base_command_line_h

#include <string>
#include <vector>

namespace Heddle
{
  /** What the command line asks for. */
  struct CommandLine
  {
    enum class Task
    {
      run,              /**< compute the scene */
      validate,         /**< read and check the scene, tell its size */
      print_parameters, /**< print all parameters with their values */
      print_text        /**< print @p text: help or version */
    };

    Task                     task = Task::run;
    std::string              text;
    std::string              parameter_file;
    std::vector<std::string> assignments;      /**< "Section/Name=value" */
    std::string              output_directory; /**< empty: as in the file */
    bool                     resume = false;
  };

  /**
   * Return what the arguments of main() ask for, or throw InputError. The first
   * argument is the name of the program.
   */
  CommandLine
  parse_command_line(const std::vector<std::string> &arguments);

  /**
   * Take what follows `--petsc`, and that word, out of the arguments of main().
   * Return the program's name and what was taken: PETSc's own arguments.
   */
  std::vector<std::string>
  take_petsc_arguments(std::vector<std::string> &arguments);
} // namespace Heddle

#endif
