#include <heddle/base/choice.h>
#include <heddle/base/exceptions.h>
#include <heddle/base/settings.h>
#include <heddle/base/throw_together.h>
#include <heddle/contributions/fabric_supports.h>
#include <heddle/simulation/matrix.h>
#include <heddle/simulation/recorder.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <filesystem>

namespace Heddle
{
  namespace Simulation
  {
    namespace
    {
      std::string
      stage_entry(const unsigned int i, const std::string &name)
      {
        return "summary/stage-" + std::to_string(i) + "/" + name;
      }



      std::string
      result_entry(const unsigned int i, const std::string &name)
      {
        return "summary/result-" + std::to_string(i) + "/" + name;
      }



      /** Writes what StageSummary::describe() shows of one stage. */
      struct StageWriter
      {
        void
        operator()(const std::string &name, const std::string &text) const
        {
          archive.write_text(stage_entry(stage, name), text);
        }

        void
        operator()(const std::string &name, const IO::Status &status) const
        {
          archive.write_text(stage_entry(stage, name), word(status));
        }

        void
        operator()(const std::string &, const IO::WallTime &time) const
        {
          IO::WallTime::describe(
            [this](const std::string &name, const double seconds) {
              (*this)("time_" + name, seconds);
            },
            time);
        }

        void
        operator()(const std::string &name, const double number) const
        {
          archive.write_number(stage_entry(stage, name), number);
        }

        ArchiveWriter     &archive;
        const unsigned int stage;
      };



      /** Its counterpart. */
      struct StageReader
      {
        void
        operator()(const std::string &name, std::string &text) const
        {
          text = archive.read_text(stage_entry(stage, name));
        }

        void
        operator()(const std::string &name, IO::Status &status) const
        {
          status =
            choice<IO::Status>(archive.read_text(stage_entry(stage, name)));
        }

        void
        operator()(const std::string &, IO::WallTime &time) const
        {
          IO::WallTime::describe(
            [this](const std::string &name, double &seconds) {
              (*this)("time_" + name, seconds);
            },
            time);
        }

        template <typename Number>
        void
        operator()(const std::string &name, Number &number) const
        {
          number = archive.read_number(stage_entry(stage, name));
        }

        const ArchiveReader &archive;
        const unsigned int   stage;
      };



      /**
       * Whether a change is of what fibers are and how they settle. Once they
       * have, their strains and stresses may be others than these parameters
       * would lead to.
       */
      bool
      is_of_settling(const std::string &change)
      {
        for (const std::string section :
             {"Fiber/", "Weave/", "Initial configuration/"})
          if (change.rfind(section, 0) == 0)
            return true;
        return false;
      }

      const char *const what_stays =
        " when fibers settled: their places and strains stay as they were";
    } // namespace



    Recorder::Place
    Recorder::resume(
      const std::vector<std::unique_ptr<Solver::LoadStepping>> &stepping,
      Log                                                      &log)
    {
      Place             place;
      const std::string path =
        IO::Checkpoint::last(directory, scene.space().communicator());
      const std::vector<Stage> &stages = scene.stages();
      const std::string         where  = "The checkpoint \"" + path + "\"";
      const auto has_settled           = [&stages](const std::string &name) {
        return std::any_of(
          stages.begin(), stages.end(), [&](const Stage &stage) {
            return stage.name == name && stage.begins_initially;
          });
      };
      const auto prepare = [&](const ArchiveReader &archive) {
        // Before what another scene has is looked for in vain.
        const bool settled = has_settled(archive.read_text("position/stage"));
        for (const std::string &change :
             changed_settings(archive.read_text("position/settings"), in_force))
          log << "Changed        " << change
              << (settled && is_of_settling(change) ? what_stays : "")
              << std::endl;
        if (!Matrix::is_in(archive))
          return;
        require(parameters.matrix.enabled,
                where + " is of fibers in a matrix, and the scene has none: "
                        "set Matrix/Enabled to true.");
        scene.embed_as(archive, where);
      };
      const auto load = [&](const ArchiveReader &archive) {
        load_summary(archive);
        place.stage = summary.stages.size() - 1;
        for (unsigned int i = 0; i <= place.stage; ++i)
          require(
            i < stages.size() && stages[i].name == summary.stages[i].name,
            where + " has \"" + summary.stages[i].name + "\" as stage " +
              std::to_string(i) + ", and this scene " +
              (i < stages.size() ? "\"" + stages[i].name + "\"" : "has none") +
              ": resume it with the parameters of its run.");
        require(!parameters.matrix.enabled || scene.matrix() ||
                  !stages[place.stage].is_loaded(),
                where + " is of fibers that are loaded without a matrix: set "
                        "Matrix/Enabled to false.");
        place.stepping = stepping[place.stage].get();
        stepping[place.stage]->load(archive);
        place.predictor.load(archive, scene.state());
        place.tries.n_unstable    = archive.read_number("tries/unstable");
        place.tries.n_jumps       = archive.read_number("tries/jumps");
        place.tries.takes_longest = archive.read_number("tries/longest") > 0.;
        balance.load(archive);
        deepest.load(archive, "deepest indentation");
        for (const auto &contribution : stages[place.stage].contributions)
          contribution->load(archive, scene.state());
      };
      const auto position = checkpoint.read(path, scene.state(), load, prepare);
      // It is there unless a stage that has yet to end writes it.
      bool is_there = true;
      for (unsigned int i = place.stage; i < stages.size(); ++i)
        {
          if (stages[i].begins_initially && i > place.stage && is_there)
            require_initial_configuration();
          if (scene.ends_initially(i) && !stepping[i]->finished())
            is_there = false;
        }
      try
        {
          history.resume(position.history);
        }
      catch (const InputError &error)
        {
          throw InputError(
            where + " has results of other kinds. " + error.what() +
            " Resume it with the parameters of its run; to load what has "
            "settled there in another way, name its folder in Restart/Initial "
            "configuration and let the results go elsewhere.");
        }
      place.number = position.number;
      return place;
    }



    std::string
    Recorder::initial_configuration_in_use() const
    {
      return given_configuration.empty()
               ? directory + "/" + initial_configuration
               : given_configuration;
    }



    void
    Recorder::require_initial_configuration() const
    {
      const std::string file     = initial_configuration_in_use();
      const bool        is_there = ask_first_rank(
        [&file]() {
          std::error_code unreachable;
          return std::filesystem::exists(file, unreachable);
        },
        scene.space().communicator());
      require(is_there,
              given_configuration.empty()
                ? "There is no file \"" + file +
                    "\", in which load cases that are still to come begin."
                : "Restart/Initial configuration: there is no file \"" + file +
                    "\"; name the folder of a run that has computed one.");
    }



    void
    Recorder::read_initial_configuration(Log &log)
    {
      require_initial_configuration();
      const std::string &file     = given_configuration;
      const std::string  settings = read_initial_configuration(file);
      for (const std::string &change : changed_settings(settings, in_force))
        if (is_of_settling(change))
          log << "Changed        " << change << what_stays << std::endl;
      const Post::CrossingCount crossings = scene.count_crossings();
      std::string               wrong     = crossings.wrong_in_words();
      if (wrong.empty())
        wrong = crossings.apart_in_words();
      require(wrong.empty(),
              "Restart/Initial configuration: in \"" + file + "\" " + wrong +
                "; it is of another weave, or of a run that ended so.");
    }



    std::string
    Recorder::read_initial_configuration(const std::string &file)
    {
      const std::string where =
        "Restart/Initial configuration: \"" + file + "\" is of ";
      const auto position =
        checkpoint.read(file, scene.state(), [&](const ArchiveReader &archive) {
          require(!Matrix::is_in(archive),
                  where +
                    "fibers in a matrix, whose tests begin in the initial "
                    "configuration; name the file \"" +
                    initial_configuration + "\" of its run.");
          require(!Contributions::FabricSupports::hold_askew(archive),
                  where + "a fabric that is sheared or bent; tests begin where "
                          "warp and weft run along x and y.");
          for (const Stage &stage : scene.stages())
            if (stage.is_loaded())
              for (const auto &contribution : stage.contributions)
                contribution->load_initial(archive, scene.state());
        });
      const auto is_of = [&position](const StageKind kind) {
        return position.stage == word(kind);
      };
      require(!is_of(StageKind::order) && !is_of(StageKind::approach) &&
                (!is_of(StageKind::settle) || scene.state().load_factor == 1.),
              where + "the stage \"" + position.stage +
                "\" before its end, where fibers are still to settle; name the "
                "file \"" +
                initial_configuration + "\" of its run.");
      scene.state().step        = 0;
      scene.state().load_factor = 0.;
      return position.settings;
    }



    void
    Recorder::return_to_initial_configuration()
    {
      read_initial_configuration(initial_configuration_in_use());
    }



    void
    Recorder::save(ArchiveWriter &archive, const Place &place) const
    {
      if (scene.matrix())
        scene.matrix()->save(archive, scene.state());
      place.stepping->save(archive);
      place.predictor.save(archive, scene.state());
      archive.write_number("tries/unstable", place.tries.n_unstable);
      archive.write_number("tries/jumps", place.tries.n_jumps);
      archive.write_number("tries/longest", place.tries.takes_longest);
      balance.save(archive);
      deepest.save(archive, "deepest indentation");
      for (const auto &contribution : scene.stages()[place.stage].contributions)
        contribution->save(archive, scene.state());
      // The first rank alone knows of them.
      const auto results = Utilities::MPI::broadcast(
        scene.space().communicator(), summary.results);
      archive.write_number("summary/n_results", results.size());
      unsigned int n = 0;
      for (const auto &result : results)
        {
          archive.write_text(result_entry(n, "name"), result.first);
          archive.write_number(result_entry(n++, "value"), result.second);
        }
      archive.write_number("summary/n_stages", summary.stages.size());
      for (unsigned int i = 0; i < summary.stages.size(); ++i)
        IO::StageSummary::describe(StageWriter{archive, i}, summary.stages[i]);
    }



    void
    Recorder::load_summary(const ArchiveReader &archive)
    {
      const unsigned int n_results = archive.read_number("summary/n_results");
      for (unsigned int i = 0; i < n_results; ++i)
        summary.results[archive.read_text(result_entry(i, "name"))] =
          archive.read_number(result_entry(i, "value"));
      summary.stages.resize(archive.read_number("summary/n_stages"));
      for (unsigned int i = 0; i < summary.stages.size(); ++i)
        IO::StageSummary::describe(StageReader{archive, i}, summary.stages[i]);
    }



    void
    Recorder::write_checkpoint(const Place &place, const std::string &path)
    {
      update_times();
      checkpoint.write(
        {scene.stages()[place.stage].name,
         place.number,
         in_force,
         history.csv()},
        scene.state(),
        [&](ArchiveWriter &archive) { save(archive, place); },
        path);
    }
  } // namespace Simulation
} // namespace Heddle
