#include <heddle/base/exceptions.h>
#include <heddle/base/file.h>
#include <heddle/base/folder_lock.h>
#include <heddle/base/throw_together.h>
#include <heddle/base/version.h>
#include <heddle/simulation/computation.h>
#include <heddle/simulation/inactive_parameters.h>
#include <heddle/simulation/own_tangents.h>
#include <heddle/simulation/run.h>
#include <heddle/simulation/scene_description.h>

#include <deal.II/base/mpi.h>

#include <filesystem>

namespace Heddle
{
  namespace Simulation
  {
    namespace
    {
      /** Where results go: command line, parameter, or the file's name. */
      std::string
      output_directory(const CommandLine   &command_line,
                       const RunParameters &parameters)
      {
        if (!command_line.output_directory.empty())
          return command_line.output_directory;
        if (!parameters.output_directory.empty())
          return parameters.output_directory;
        const std::filesystem::path file(command_line.parameter_file);
        return "output/" + file.stem().string();
      }



      void
      print_banner(Log &log, const MPI_Comm communicator)
      {
        std::string versions = version_text();
        for (auto end = versions.find('\n'); end != std::string::npos;
             end      = versions.find('\n'))
          versions.replace(end, 1, ", ");
        const unsigned int n = Utilities::MPI::n_mpi_processes(communicator);
        log << versions << n << (n == 1 ? " rank" : " ranks") << std::endl;
      }



      /** Whether these are names of one file, or of one folder. */
      bool
      are_one(const std::string &left,
              const std::string &right,
              const MPI_Comm     communicator)
      {
        return ask_first_rank(
          [&]() {
            std::error_code none_there;
            return std::filesystem::equivalent(left, right, none_there);
          },
          communicator);
      }



      /** What is removed or written over must not be what the run reads. */
      void
      spare_centerlines(const std::string &given,
                        const std::string &directory,
                        const MPI_Comm     communicator)
      {
        for (const std::string table : Recorder::tables)
          {
            const std::string own = directory + "/" + table;
            require(!are_one(own, given, communicator),
                    "Centerlines/File is \"" + own +
                      "\", where this run leaves its own; give it another "
                      "name, or write to another folder.");
          }
      }



      void
      spare_checkpoint(const std::string &given,
                       const std::string &directory,
                       const MPI_Comm     communicator)
      {
        const std::string own = directory + "/checkpoint";
        const std::string folder =
          (std::filesystem::path(".") / given).parent_path();
        require(given.empty() || !are_one(own, folder, communicator),
                "Restart/Initial configuration is \"" + given +
                  "\", one of the checkpoints that this run removes; copy it, "
                  "or write to another folder.");
      }



      /** Compute the scene and leave the results in its folder. */
      void
      compute(const CommandLine &command_line,
              const std::string &directory,
              Computation       &computation,
              Log               &log,
              const MPI_Comm     communicator)
      {
        if (command_line.resume)
          IO::Checkpoint::require_one(directory, communicator);
        throw_together([&]() { create_folder(directory); }, communicator);
        const FolderLock lock(directory, communicator);
        // Nothing is written before it is clear that the run goes on.
        if (command_line.resume)
          computation.read_checkpoint();
        log.open(directory + "/log.txt",
                 command_line.resume ? std::ios_base::app : std::ios_base::out);
        log << "Results        " << directory << std::endl;
        computation.run();
      }
    } // namespace



    void
    run(const CommandLine      &command_line,
        const MPI_Comm          communicator,
        const OwnContributions &make_own)
    {
      ParameterFile file =
        command_line.parameter_file.empty()
          ? ParameterFile()
          : ParameterFile(command_line.parameter_file, communicator);
      for (const std::string &assignment : command_line.assignments)
        file.set(assignment);
      const Parameters parameters(file);
      Log              log(communicator);
      if (command_line.task == CommandLine::Task::print_parameters)
        {
          log << Parameters::text() << std::flush;
          return;
        }

      SectionTimer timer;
      StopRequest  stop(communicator);
      stop.set_limit(parameters.run.wall_time_limit);
      // What is validated leaves nothing behind, and has nowhere to stop.
      if (command_line.task != CommandLine::Task::validate)
        stop.catch_signals();
      print_banner(log, communicator);
      parameters.check(file);
      for (const std::string &sentence : inactive_parameters(file))
        log << "Note           " << sentence << std::endl;
      const std::string directory =
        output_directory(command_line, parameters.run);
      spare_centerlines(relative_to(file.name(), parameters.centerlines.file),
                        directory,
                        communicator);
      spare_checkpoint(
        parameters.restart.initial_configuration, directory, communicator);
      Scene scene(parameters, file.name(), communicator, make_own);
      print_description(log, scene, parameters);
      Recorder    recorder(scene, parameters, file, directory, timer);
      Computation computation(scene, parameters, recorder, log, timer, stop);
      if (command_line.task == CommandLine::Task::validate)
        {
          if (command_line.resume)
            computation.read_checkpoint();
          else if (!parameters.restart.initial_configuration.empty())
            recorder.read_initial_configuration(log);
          print_own_tangents(log, scene);
          return;
        }

      compute(command_line, directory, computation, log, communicator);
      if (parameters.run.timing)
        log << timer.table() << std::flush;
    }
  } // namespace Simulation
} // namespace Heddle
