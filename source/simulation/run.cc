#include <heddle/base/exceptions.h>
#include <heddle/base/file.h>
#include <heddle/base/folder_lock.h>
#include <heddle/base/throw_together.h>
#include <heddle/base/version.h>
#include <heddle/simulation/computation.h>
#include <heddle/simulation/inactive_parameters.h>
#include <heddle/simulation/run.h>
#include <heddle/textile/linear_density.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <sstream>

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



      /** "2.4 x 2.4 x 0.1 mm": what shows that a length is in another unit. */
      std::string
      extent_in_words(const Scene &scene)
      {
        const System::FiberSpace &space = scene.space();
        const double              none  = std::numeric_limits<double>::max();
        std::vector<double>       low(3, none), high(3, -none);
        for (std::size_t b = 0; b < scene.initial().size();
             b += space.n_blocks_per_node())
          for (unsigned int d = 0; d < 3; ++d)
            {
              low[d]  = std::min(low[d], scene.initial()[b][d]);
              high[d] = std::max(high[d], scene.initial()[b][d]);
            }
        Utilities::MPI::min(low, space.communicator(), low);
        Utilities::MPI::max(high, space.communicator(), high);
        std::ostringstream text;
        text << std::setprecision(3) << high[0] - low[0] << " x "
             << high[1] - low[1] << " x " << high[2] - low[2] << " mm";
        return text.str();
      }



      /** What yarns and fabric weigh, if the densities of fibers are known. */
      void
      print_weights(Log                             &log,
                    const Textile::Weave            &weave,
                    const Textile::WeaveDescription &description)
      {
        const bool warp = description.warp.density > 0.,
                   weft = description.weft.density > 0.;
        if (warp)
          log << "Warp           "
              << Textile::yarns_in_words(description.warp, weave.warp_spacing())
              << '\n';
        if (weft)
          log << "Weft           "
              << Textile::yarns_in_words(description.weft, weave.weft_spacing())
              << '\n';
        // Grams per kilometer over millimeters are grams per square meter.
        if (warp && weft)
          log << "Areal weight   " << std::setprecision(3)
              << Textile::linear_density(description.warp) /
                     weave.warp_spacing() +
                   Textile::linear_density(description.weft) /
                     weave.weft_spacing()
              << " g/m^2, without crimp\n";
      }



      /** "94.3" or, where fibers differ, "94.3 to 120" [MPa]. */
      std::string
      tension_in_words(const System::FiberSpace &space, const double strain)
      {
        double low = std::numeric_limits<double>::max(), high = 0.;
        for (unsigned int f = 0; f < space.n_fibers(); ++f)
          {
            const double radius = space.fiber(f).radius;
            const double stress = strain * space.fiber(f).section.axial /
                                  (numbers::PI * radius * radius);
            low  = std::min(low, stress);
            high = std::max(high, stress);
          }
        std::ostringstream text;
        text << std::setprecision(3) << low;
        if (high > 1.001 * low)
          text << " to " << high;
        return text.str();
      }



      /** How many fibers are of each material, a line if there are several. */
      std::string
      materials_in_words(const System::FiberSpace &space,
                         const FiberParameters    &parameters)
      {
        if (parameters.materials.empty())
          return "";
        const auto  numbers = parameters.materials_of(space.names());
        std::string text;
        for (unsigned int i = 0; i <= parameters.materials.size(); ++i)
          text +=
            (i == 0 ? "Materials      " : ", ") +
            std::to_string(std::count(numbers.begin(), numbers.end(), i)) +
            (i == 0 ? " fibers of section Fiber"
                    : " of Material " + std::to_string(i));
        return text + '\n';
      }



      /** Sheared by more, a linear matrix is off by some percent [degrees]. */
      constexpr double large_angle = 10.;



      void
      print_sizes(Log &log, const Scene &scene, const Parameters &parameters)
      {
        const System::FiberSpace &space  = scene.space();
        const MatrixEstimate      matrix = scene.estimated_matrix();
        // Only a fabric is elsewhere when its fibers are embedded.
        require(matrix.objection.empty() || scene.is_fabric(),
                matrix.objection);
        log << "Fibers         " << space.n_fibers();
        if (space.n_yarns() > 0)
          log << " in " << space.n_yarns() << " yarns";
        log << '\n' << materials_in_words(space, parameters.fiber);
        if (scene.weave())
          print_weights(log, *scene.weave(), parameters.weave.description());
        if (scene.is_fabric() &&
            parameters.restart.initial_configuration.empty())
          log << "Tension        "
              << tension_in_words(space, parameters.settle.axial_tension)
              << " MPa in every fiber while the fabric settles, with which a "
                 "test begins (Initial configuration/Axial tension)\n";
        // The stress at a strain of 1e-3, in MPa, is the modulus in GPa, as
        // data sheets have it.
        log << "Stiffness      " << tension_in_words(space, /*strain=*/1e-3)
            << " GPa along the fibers (Fiber/Axial modulus, or Axial "
               "stiffness over the area)\n"
            << "Extent         " << extent_in_words(scene) << " at the start\n"
            << "Nodes          " << space.n_nodes() << '\n'
            << "Unknowns       " << space.n_dofs() << '\n';
        if (!matrix.objection.empty())
          log << "Matrix         not known where the fibers start: "
              << matrix.objection << '\n';
        else if (parameters.matrix.enabled)
          log << "Matrix         about " << std::lround(matrix.n_cells)
              << " cells, " << std::lround(matrix.n_nodes) << " nodes, "
              << std::lround(3. * matrix.n_nodes)
              << " unknowns, around the fibers where they start\n";
        for (const std::string &note : scene.notes())
          log << "Note           " << note << '\n';
        log << "Contributions  ";
        if (scene.stages().empty())
          {
            log << "none: nothing holds or loads the fibers, which are "
                   "measured as they are"
                << std::endl;
            return;
          }
        std::string comma;
        for (const std::string &name : scene.contribution_names())
          {
            log << comma << name;
            comma = ", ";
          }
        for (const std::string &overlap : scene.overlaps_at_start())
          log << "\nNote           " << overlap;
        if (parameters.matrix.enabled &&
            parameters.matrix.material.law == Solid::MaterialLaw::linear &&
            parameters.fabric_loading.largest_shear_angle() > large_angle)
          log << "\nNote           Matrix/Law is linear, which takes turns for "
                 "strains: under such shear another one is right";
        log << "\nLinear solver  "
            << (scene.will_be_factorized(matrix.n_nodes) ? "direct"
                                                         : "fiber blocks")
            << "\nMemory         about " << std::fixed << std::setprecision(0)
            << std::ceil(scene.estimated_memory(matrix.n_nodes) / 1e6) << " MB"
            << "\nTime           about " << std::setprecision(1)
            << std::max(0.1, scene.estimated_seconds(matrix.n_nodes))
            << " s for a Newton iteration; "
            << (scene.is_fabric() &&
                    parameters.restart.initial_configuration.empty()
                  ? "an initial configuration takes 40 to 160, "
                  : "")
            << "a load step " << (scene.is_fabric() ? "3 to 20" : "3 to 60")
            << std::endl;
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
        const std::string own = directory + "/" + Recorder::centerlines;
        require(!are_one(own, given, communicator),
                "Centerlines/File is \"" + own +
                  "\", where this run leaves its own; give it another name, "
                  "or write to another folder.");
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
      print_sizes(log, scene, parameters);
      Recorder    recorder(scene, parameters, file, directory, timer);
      Computation computation(scene, parameters, recorder, log, timer, stop);
      if (command_line.task == CommandLine::Task::validate)
        {
          if (command_line.resume)
            computation.read_checkpoint();
          else if (!parameters.restart.initial_configuration.empty())
            recorder.read_initial_configuration(log);
          return;
        }

      compute(command_line, directory, computation, log, communicator);
      if (parameters.run.timing)
        log << timer.table() << std::flush;
    }
  } // namespace Simulation
} // namespace Heddle
