#include <heddle/base/command_line.h>
#include <heddle/base/exceptions.h>
#include <heddle/base/version.h>

#include <CLI/CLI.hpp>

#include <algorithm>

namespace Heddle
{
  CommandLine
  parse_command_line(const std::vector<std::string> &arguments)
  {
    CommandLine result;
    bool        version          = false;
    bool        validate         = false;
    bool        print_parameters = false;

    CLI::App app(
      "Simulates woven fabrics fiber by fiber. Units: mm, N, MPa, s.",
      "heddle");
    app.footer("Exit codes: 0 done, 1 internal error, 2 bad input,\n"
               "3 not converged (last good state kept), 4 stopped.\n"
               "What follows --petsc goes to PETSc, as in --petsc -log_view.");
    app.set_help_flag("-h,--help", "Print this text");
    app.add_flag("-v,--version", version, "Print the versions of all parts");
    app.add_flag("--validate",
                 validate,
                 "Read and check the scene, and with --resume the last state, "
                 "and print its size; solve nothing");
    app.add_flag("--print-parameters",
                 print_parameters,
                 "Print all parameters, of the scene if there is one, with "
                 "their meaning");
    app
      .add_option("--set",
                  result.assignments,
                  "Set one parameter after the file was read; repeatable")
      ->type_name("\"SECTION/NAME=VALUE\"")
      ->type_size(1)
      ->allow_extra_args(false);
    app
      .add_option("--output-directory",
                  result.output_directory,
                  "Write here, whatever the file says")
      ->type_name("DIR");
    app.add_flag(
      "--resume", result.resume, "Go on from the last state that was saved");
    app.add_option("file", result.parameter_file, "The scene to compute")
      ->type_name("FILE.prm");

    // CLI11 takes the arguments from the back, without the program's name.
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend() - 1);
    try
      {
        app.parse(reversed);
      }
    catch (const CLI::CallForHelp &)
      {
        result.task = CommandLine::Task::print_text;
        result.text = app.help();
        return result;
      }
    catch (const CLI::ParseError &error)
      {
        throw InputError(std::string(error.what()) +
                         ". Try \"heddle --help\".");
      }

    if (version)
      {
        result.task = CommandLine::Task::print_text;
        result.text = version_text();
        return result;
      }
    require(print_parameters || !result.parameter_file.empty(),
            "No parameter file was given. Try \"heddle --help\".");
    require(!(validate && print_parameters),
            "Choose one of --validate and --print-parameters.");
    if (validate)
      result.task = CommandLine::Task::validate;
    if (print_parameters)
      result.task = CommandLine::Task::print_parameters;
    return result;
  }



  std::vector<std::string>
  take_petsc_arguments(std::vector<std::string> &arguments)
  {
    std::vector<std::string> petsc = {arguments.front()};
    const auto mark = std::find(arguments.begin(), arguments.end(), "--petsc");
    if (mark != arguments.end())
      petsc.insert(petsc.end(), mark + 1, arguments.end());
    arguments.erase(mark, arguments.end());
    return petsc;
  }
} // namespace Heddle
