#include <heddle/base/exceptions.h>
#include <heddle/base/file.h>
#include <heddle/base/settings.h>
#include <heddle/base/throw_together.h>
#include <heddle/base/version.h>
#include <heddle/io/collection.h>
#include <heddle/post/centerline.h>
#include <heddle/simulation/crossing_report.h>
#include <heddle/simulation/matrix.h>
#include <heddle/simulation/recorder.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>

namespace Heddle
{
  namespace Simulation
  {
    namespace
    {
      /** Beside what contributions report. */
      const char *const energy_imbalance = "energy_imbalance[N*mm]";

      /** Name and unit of "name[unit]". */
      IO::History::Column
      split(const std::string &name_with_unit)
      {
        // Sets of fibers may have brackets in their names.
        const auto bracket = name_with_unit.rfind('[');
        require(bracket != std::string::npos && bracket > 0 &&
                  name_with_unit.back() == ']' &&
                  name_with_unit.find_first_of(",\"\n") == std::string::npos,
                "A contribution reports \"" + name_with_unit +
                  "\", which is no name[unit].");
        return {name_with_unit.substr(0, bracket),
                name_with_unit.substr(bracket + 1,
                                      name_with_unit.size() - bracket - 2)};
      }



      /** What a fabric is measured by in each step, with units, whether it is
       * or not: a run may be resumed otherwise. */
      std::vector<std::string>
      measures_of_fabric(const System::FiberSpace &space)
      {
        std::set<std::string> names;
        for (unsigned int f = 0; f < space.n_fibers(); ++f)
          if (space.fiber(f).yarn_id != numbers::invalid_unsigned_int)
            {
              const std::string &set    = space.fiber(f).set;
              const std::string  of_set = set.empty() ? "" : set + "_";
              for (const char *name : {"crimp[-]",
                                       "inner_crimp[-]",
                                       "spacing[mm]",
                                       "aspect_ratio[-]",
                                       "volume_fraction[-]"})
                names.insert(of_set + name);
              names.insert({"thickness[mm]", "fiber_volume_fraction[-]"});
            }
        return {names.begin(), names.end()};
      }



      std::vector<IO::History::Column>
      columns_of(Scene &scene)
      {
        auto values = scene.report();
        if (EnergyBalance::is_in(values))
          values[energy_imbalance] = 0.;
        for (const std::string &name : measures_of_fabric(scene.space()))
          values.insert({name, 0.});
        std::vector<IO::History::Column> columns;
        for (const auto &value : values)
          columns.push_back(split(value.first));
        return columns;
      }



      /** The file that @p path is, or that is in this folder. */
      std::string
      configuration_file(const std::string &path)
      {
        std::error_code none_there;
        return std::filesystem::is_directory(path, none_there)
                 ? path + "/" + Recorder::initial_configuration
                 : path;
      }



      /** What version_text() says, by library. */
      std::map<std::string, std::string>
      versions()
      {
        std::map<std::string, std::string> result;
        std::istringstream                 lines(version_text());
        for (std::string line; std::getline(lines, line);)
          {
            const auto space              = line.find(' ');
            result[line.substr(0, space)] = line.substr(space + 1);
          }
        return result;
      }
    } // namespace



    Recorder::Recorder(Scene               &scene,
                       const Parameters    &parameters,
                       const ParameterFile &file,
                       const std::string   &directory,
                       SectionTimer        &timer)
      : scene(scene)
      , parameters(parameters)
      , file(file)
      , directory(directory)
      , in_force(settings_text(ParameterAcceptor::prm))
      , given_configuration(ask_first_rank(
          [&]() {
            return configuration_file(parameters.restart.initial_configuration);
          },
          scene.space().communicator()))
      , timer(timer)
      , first_rank(
          Utilities::MPI::this_mpi_process(scene.space().communicator()) == 0)
      , history(directory, scene.space().communicator(), columns_of(scene))
      , checkpoint(scene.space(), directory, parameters.output.n_checkpoints)
    {
      summary.n_fibers      = scene.space().n_fibers();
      summary.n_fiber_nodes = scene.space().n_nodes();
      summary.ranks =
        Utilities::MPI::n_mpi_processes(scene.space().communicator());
      summary.contributions = scene.contribution_names();
      summary.versions      = versions();
    }



    void
    Recorder::begin(const Place &place)
    {
      if (first_rank)
        clear_folder();
      write_parameters();
      open_outputs(0);
      write_pictures(place, "start");
      if (scene.stages().empty())
        {
          measure_yarns(place);
          write_centerlines();
        }
      write_summary();
    }



    bool
    Recorder::has_ended(const Place &place) const
    {
      return place.stepping->finished() &&
             place.stage + 1 == scene.stages().size();
    }



    void
    Recorder::continue_from(const Place &place)
    {
      // What came after the checkpoint is not listed any more.
      if (place.number > 0)
        history.write();
      open_outputs(place.number == 0 ? 0 : place.number + 1);
      if (place.number == 0)
        write_pictures(place, "start");
      if (!has_ended(place))
        {
          write_parameters();
          // What is written at the end of a stage is in no checkpoint, and
          // there may be that of a later one.
          if (place.stepping->finished())
            {
              measure_yarns(place);
              write_centerlines();
            }
        }
      write_summary();
    }



    void
    Recorder::clear_folder() const
    {
      // It may begin in an initial configuration that lies here.
      namespace files       = std::filesystem;
      const std::string own = directory + "/" + initial_configuration;
      std::error_code   none_there;
      if (given_configuration.empty() ||
          !files::equivalent(own, given_configuration, none_there))
        files::remove(own);
      for (const std::string table : tables)
        files::remove(directory + "/" + table);
      for (const std::string name :
           {"fibers", "contacts", "plates", "matrix", "coupling"})
        IO::Collection::remove(directory, name);
      IO::Checkpoint::remove_all(directory);
    }



    void
    Recorder::write_parameters() const
    {
      if (!first_rank)
        return;
      write_file(directory + "/original.prm", file.text());
      write_file(directory + "/parameters.prm", Parameters::text());
    }



    void
    Recorder::open_outputs(const unsigned int next)
    {
      if (parameters.output.interval > 0 && parameters.output.fibers)
        fibers = std::make_unique<IO::FiberOutput>(
          scene.space(), parameters.output.subdivisions, directory, next);
      if (fibers && parameters.plates.are_there())
        plates = std::make_unique<IO::PlateOutput>(
          directory, scene.space().communicator(), next);
      if (parameters.output.interval > 0 && parameters.output.contacts &&
          scene.contact())
        contacts = std::make_unique<IO::ContactOutput>(
          scene.space(), scene.friction() != nullptr, directory, next);
      if (parameters.output.interval > 0 && parameters.output.matrix &&
          parameters.matrix.enabled)
        matrix = std::make_unique<IO::MatrixOutput>(
          directory, scene.space().communicator(), next);
    }



    void
    Recorder::begin_stage(const unsigned int stage)
    {
      if (stage == summary.stages.size())
        {
          deepest = {};
          summary.stages.emplace_back();
          summary.stages.back().name = scene.stages()[stage].name;
          if (!parameters.run.timing)
            IO::WallTime::describe(
              [](const std::string &, double &seconds) {
                seconds = std::numeric_limits<double>::quiet_NaN();
              },
              summary.stages.back().wall_time);
        }
      else if (summary.stages.back().status != IO::Status::converged)
        summary.stages.back().status = IO::Status::running;
      earlier  = summary.stages.back().wall_time;
      at_begin = clock();
      write_summary();
    }



    void
    Recorder::count(const unsigned int          stage,
                    const Solver::NewtonResult &result)
    {
      IO::StageSummary &entry = summary.stages[stage];
      entry.newton_iterations += result.iterations;
      entry.factorizations += result.factorizations;
      entry.linear_iterations += result.linear_iterations;
    }



    void
    Recorder::add_step(const Place &place, const Solver::NewtonResult &result)
    {
      write_results(place, result);
      // What that took is over by now, and counts.
      write_summary();
    }



    void
    Recorder::write_results(const Place                &place,
                            const Solver::NewtonResult &result)
    {
      SectionTimer::Scope scope(timer, "output");
      measure(place, result);
      const bool         last = place.stepping->finished();
      const unsigned int step = scene.state().step;
      if (parameters.output.due(step, last))
        {
          write_pictures(place, scene.stages()[place.stage].name);
          summary.stages[place.stage].last_output = place.number;
        }
      if (last)
        {
          summary.stages[place.stage].status = IO::Status::converged;
          measure_yarns(place);
          write_centerlines();
        }
      // Once there is a checkpoint, a run may go on from this configuration.
      if (last && scene.ends_initially(place.stage))
        write_checkpoint(place, directory + "/" + initial_configuration);
      if (parameters.output.checkpoint_due(step, last))
        write_checkpoint(place);
    }



    void
    Recorder::keep(const Place &place)
    {
      const unsigned int step  = scene.state().step;
      const bool         last  = place.stepping->finished();
      int               &drawn = summary.stages[place.stage].last_output;
      // A step to load factor 0 has no picture (OutputParameters::due()).
      const bool draws = parameters.output.interval > 0 && step > 0 &&
                         drawn != static_cast<int>(place.number);
      if (draws)
        {
          write_pictures(place, scene.stages()[place.stage].name);
          drawn = place.number;
        }
      // Which was drawn last is in it.
      if (draws || !parameters.output.checkpoint_due(step, last))
        write_checkpoint(place);
    }



    void
    Recorder::measure(const Place &place, const Solver::NewtonResult &result)
    {
      IO::StageSummary &stage = summary.stages[place.stage];
      ++stage.steps;
      stage.residual_ratio  = result.residual_ratio;
      stage.n_dofs_per_rank = Utilities::MPI::max(
        3 * scene.state().n_local_blocks(), scene.space().communicator());
      auto values = scene.report(place.stage);
      if (scene.contact())
        {
          stage.contact_elements        = values["contact_elements[-]"];
          stage.active_contact_elements = values["active_contact_elements[-]"];
          stage.max_penetration_ratio   = values["max_penetration_ratio[-]"];
          if (scene.contact()->indentation().ratio >= deepest.ratio)
            {
              deepest        = scene.contact()->indentation();
              deepest.energy = EnergyBalance::elastic_energy(values);
            }
          stage.max_indentation_ratio  = deepest.ratio;
          stage.indentation_work_ratio = deepest.work_ratio();
        }
      stage.max_bend_ratio  = values["max_bend_ratio[-]"];
      stage.crossings_total = place.crossings.total;
      stage.crossings_wrong = place.crossings.wrong;
      stage.crossings_apart = place.crossings.apart;
      if (EnergyBalance::is_in(values))
        {
          if (scene.state().load_factor == 0. ||
              !scene.stages()[place.stage].is_loaded())
            balance.begin(values);
          else
            balance.add(values);
          values[energy_imbalance] = balance.imbalance();
        }
      measure_fabric(place, values);
      add_to_history(place, result, values);
    }



    void
    Recorder::begin_balance(const unsigned int stage)
    {
      const auto values = scene.report(stage);
      if (EnergyBalance::is_in(values))
        balance.begin(values);
    }



    FabricReport
    Recorder::measured(const Place &place) const
    {
      const std::vector<Stage> &stages = scene.stages();
      return FabricReport(scene.state(),
                          stages.empty() ? PointMap()
                                         : stages[place.stage].flattened);
    }



    void
    Recorder::measure_fabric(const Place                   &place,
                             std::map<std::string, double> &values) const
    {
      const unsigned int n_stations = parameters.output.yarn_stations;
      if (scene.space().n_yarns() == 0 || n_stations == 0)
        return;
      // Checkpoints hold the history, and all ranks write them.
      const auto results = Utilities::MPI::broadcast(
        scene.space().communicator(), measured(place).results(n_stations, {}));
      for (const auto &result : results)
        if (history.has_column(split(result.first).first))
          values.insert(result);
    }



    void
    Recorder::measure_yarns(const Place &place)
    {
      const unsigned int n_stations = parameters.output.yarn_stations;
      if (scene.space().n_yarns() == 0)
        return;
      if (n_stations == 0)
        {
          // Those of a run that is resumed are of an earlier stage.
          summary.results.clear();
          overfull.clear();
          if (first_rank)
            for (const std::string table :
                 {"yarns.csv", "orientation.csv", "crossings.csv"})
              std::filesystem::remove(directory + "/" + table);
          return;
        }
      const FabricReport fabric    = measured(place);
      const std::string  crossings = crossings_csv(scene, fabric);
      if (!first_rank)
        return;
      summary.results = fabric.results(n_stations, scene.densities());
      overfull        = fabric.overfull(n_stations);
      write_file(directory + "/yarns.csv", fabric.yarns_csv(n_stations));
      write_file(directory + "/orientation.csv", fabric.orientation_csv());
      write_file(directory + "/crossings.csv", crossings);
    }



    void
    Recorder::write_centerlines() const
    {
      if (parameters.output.interval == 0 || !parameters.output.centerlines)
        return;
      const std::string table = Post::centerlines_csv(scene.state());
      if (first_rank)
        write_file(directory + "/" + centerlines, table);
    }



    void
    Recorder::add_to_history(const Place                         &place,
                             const Solver::NewtonResult          &result,
                             const std::map<std::string, double> &values)
    {
      std::map<std::string, double> row;
      for (const auto &value : values)
        row[split(value.first).first] = value.second;
      row["step"]              = place.number;
      row["stage"]             = place.stage;
      row["load_factor"]       = scene.state().load_factor;
      row["newton_iterations"] = result.iterations;
      row["residual_ratio"]    = result.residual_ratio;
      history.add(row);
    }



    void
    Recorder::write_pictures(const Place &place, const std::string &group)
    {
      // A stage adds one to the time that is shown, its load factor in it.
      const double time = place.stage + scene.state().load_factor;
      if (fibers)
        fibers->write(
          scene.state(),
          scene.initial(),
          [this](const unsigned int f, const unsigned int e) {
            return scene.elasticity().reference_strains(f, e);
          },
          place.number,
          time,
          group);
      if (contacts)
        contacts->write(scene.contact()->elements(),
                        scene.friction()
                          ? scene.friction()->tangential_forces(scene.state())
                          : std::vector<Contact::TangentialForce>(),
                        scene.state(),
                        place.number,
                        time,
                        group);
      if (plates)
        write_plates(place, time, group);
      if (matrix && scene.matrix())
        write_matrix(place, time, group);
    }



    void
    Recorder::write_plates(const Place       &place,
                           const double       time,
                           const std::string &group)
    {
      const Contributions::Plates *const drawn =
        place.stage < scene.stages().size() ? scene.plates(place.stage)
                                            : nullptr;
      if (drawn && drawn->are_placed())
        plates->write(drawn->extent(scene.state()),
                      drawn->heights(),
                      drawn->forces(),
                      place.number,
                      time,
                      group);
    }



    void
    Recorder::write_matrix(const Place       &place,
                           const double       time,
                           const std::string &group)
    {
      const auto means = [this](const unsigned int c) {
        IO::CellMeans means;
        const auto    points =
          scene.matrix()->elasticity()->evaluate(scene.state(), c);
        double volume = 0.;
        for (const Solid::PointState &point : points)
          {
            volume += point.volume;
            means.strain += point.volume * point.strain;
            means.stress += point.volume * point.stress;
          }
        means.strain /= volume;
        means.stress /= volume;
        means.von_mises = Solid::von_mises(means.stress);
        return means;
      };
      std::vector<IO::LinkPoint> links;
      for (const auto &link : scene.matrix()->coupling()->points(scene.state()))
        links.push_back({link.fiber, link.position, link.force, link.length});
      matrix->write(scene.state(), means, links, place.number, time, group);
    }



    IO::WallTime
    Recorder::clock() const
    {
      IO::WallTime time;
      IO::WallTime::describe(
        [this](std::string name, double &seconds) {
          std::replace(name.begin(), name.end(), '_', ' ');
          seconds = name == "total" ? timer.total() : timer.seconds(name);
        },
        time);
      return time;
    }



    void
    Recorder::update_times()
    {
      if (!parameters.run.timing || summary.stages.empty())
        return;
      const IO::WallTime now = clock();
      IO::WallTime::describe(
        [](const std::string &,
           double      &sum,
           const double before,
           const double until,
           const double since) { sum = before + until - since; },
        summary.stages.back().wall_time,
        earlier,
        now,
        at_begin);
    }



    void
    Recorder::finish(const IO::Status status, const std::string &reason)
    {
      summary.status = status;
      summary.reason = reason;
      if (!summary.stages.empty() && status != IO::Status::converged)
        summary.stages.back().status = status;
      write_summary();
    }



    void
    Recorder::write_summary()
    {
      update_times();
      // A matrix is there when a stage with loads has begun.
      summary.n_dofs = scene.state().n_dofs();
      if (const Matrix *matrix = scene.matrix())
        summary.matrix = matrix->summary();
      if (first_rank)
        summary.write(directory);
    }
  } // namespace Simulation
} // namespace Heddle
