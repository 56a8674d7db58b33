#ifndef heddle_simulation_recorder_h
#define heddle_simulation_recorder_h

#include <heddle/base/log.h>
#include <heddle/base/parameter_file.h>
#include <heddle/base/timer.h>
#include <heddle/io/checkpoint.h>
#include <heddle/io/contact_output.h>
#include <heddle/io/fiber_output.h>
#include <heddle/io/history.h>
#include <heddle/io/matrix_output.h>
#include <heddle/io/plate_output.h>
#include <heddle/io/summary.h>
#include <heddle/simulation/energy_balance.h>
#include <heddle/simulation/fabric_report.h>
#include <heddle/simulation/scene.h>
#include <heddle/solver/predictor.h>

#include <array>
#include <map>
#include <memory>
#include <string>

namespace Heddle
{
  namespace Simulation
  {
    /**
     * Keeps and writes what a run leaves behind: summary, history, pictures of
     * fibers and contacts, yarn sections, centerlines, checkpoints. What is not
     * asked for is not computed.
     */
    class Recorder
    {
    public:
      /** Where the end of the stages without loads is kept, in the folder. */
      static constexpr const char *initial_configuration =
        "initial_configuration.h5";

      /** Where the fibers are at the end of a stage, in the folder. */
      static constexpr const char *centerlines = "centerlines.csv";

      /** Tables of results in the folder, which a new run removes. */
      static constexpr std::array<const char *, 5> tables = {{"history.csv",
                                                              "yarns.csv",
                                                              "orientation.csv",
                                                              "crossings.csv",
                                                              centerlines}};

      /** What the steps of a stage have met that bears on those to come. */
      struct Tries
      {
        /** Steps that ended in an equilibrium that is not stable. */
        unsigned int n_unstable = 0;

        /** How often in a row the next one was halved lest it end so. */
        unsigned int n_jumps = 0;

        /** Whether it gets as many iterations as any search may take. */
        bool takes_longest = false;
      };

      /** Where the run stands. */
      struct Place
      {
        unsigned int                stage    = 0; /**< number of the stage */
        unsigned int                number   = 0; /**< step, over all stages */
        const Solver::LoadStepping *stepping = nullptr;
        Solver::Predictor           predictor;
        Tries                       tries;

        /** Where the last step that came to equilibrium has led. */
        Post::CrossingCount crossings;
      };

      /** The folder must exist where anything is written. @note Collective. */
      Recorder(Scene               &scene,
               const Parameters    &parameters,
               const ParameterFile &file,
               const std::string   &directory,
               SectionTimer        &timer);

      /**
       * Return the stage and the number of the step that the last checkpoint
       * was written after; the state of the scene is set, and @p stepping of
       * that stage. What was set otherwise in that run goes to the log.
       * @note Collective.
       */
      Place
      resume(const std::vector<std::unique_ptr<Solver::LoadStepping>> &stepping,
             Log                                                      &log);

      /**
       * Write what there is before the first step, and remove what an earlier
       * run has left in the folder that this one might be resumed from.
       */
      void
      begin(const Place &place);

      /** Write what there is after resume(). */
      void
      continue_from(const Place &place);

      /** Whether nothing is left to compute after resume(). */
      bool
      has_ended(const Place &place) const;

      void
      begin_stage(const unsigned int stage);

      /**
       * Let energies count from the state in which the stage begins, where no
       * step leads to load factor 0: fibers may have some.
       * @note Collective.
       */
      void
      begin_balance(const unsigned int stage);

      /** Add to the work of the stage, whether it led to anything or not. */
      void
      count(const unsigned int stage, const Solver::NewtonResult &result);

      /** A step was accepted. @note Collective. */
      void
      add_step(const Place &place, const Solver::NewtonResult &result);

      /**
       * Save the state as it was last accepted: to the file @p path, or, if it
       * is empty, to the next one of the checkpoints.
       * @note Collective.
       */
      void
      write_checkpoint(const Place &place, const std::string &path = "");

      /**
       * Go to the initial configuration that the parameters name, or to a dry
       * fabric under load: the state, penalties of contact and, if they are
       * there, friction and strains of reference. Throws InputError
       * if it is none, or of other fibers or another weave. Tell @p log what
       * was set otherwise when it was computed.
       * @note Collective.
       */
      void
      read_initial_configuration(Log &log);

      /** Go to the one that this run has computed, or was given. */
      void
      return_to_initial_configuration();

      /**
       * No equilibrium was found after the last step of a stage that was
       * accepted, whose state this is: save it and draw it, unless that is
       * done.
       * @note Collective.
       */
      void
      keep(const Place &place);

      /** Of the last stage with loads. */
      const EnergyBalance &
      energy_balance() const
      {
        return balance;
      }

      /** Of yarns that were measured last, and are more than full of fibers, on
       * rank 0; empty if there are none. */
      const std::string &
      overfull_yarns() const
      {
        return overfull;
      }

      /** The deepest one of the stage, over its steps. */
      const Contributions::Indentation &
      deepest_indentation() const
      {
        return deepest;
      }

      /** Write how it ended. */
      void
      finish(const IO::Status status, const std::string &reason);

    private:
      /** Of this run, or that it was given. */
      std::string
      initial_configuration_in_use() const;

      /** Throw InputError if there is no such file. */
      void
      require_initial_configuration() const;

      /** Return the parameters of the run that has written it. */
      std::string
      read_initial_configuration(const std::string &file);

      /** Remove the checkpoints and tables of an earlier run. */
      void
      clear_folder() const;

      void
      write_parameters() const;

      /** Begin to draw, from picture @p next on. */
      void
      open_outputs(const unsigned int next);

      void
      measure(const Place &place, const Solver::NewtonResult &result);

      void
      add_to_history(const Place                         &place,
                     const Solver::NewtonResult          &result,
                     const std::map<std::string, double> &report);

      /** What a step leaves in files, but for the summary. */
      void
      write_results(const Place &place, const Solver::NewtonResult &result);

      void
      write_pictures(const Place &place, const std::string &group);

      /** If there are any, and once they are somewhere. */
      void
      write_plates(const Place       &place,
                   const double       time,
                   const std::string &group);

      void
      write_matrix(const Place       &place,
                   const double       time,
                   const std::string &group);

      /** Its yarns, flattened again if they are bent. @note Collective. */
      FabricReport
      measured(const Place &place) const;

      /** Add what a fabric is measured by in each step, if wanted.
       * @note Collective. */
      void
      measure_fabric(const Place                   &place,
                     std::map<std::string, double> &values) const;

      /** Sections of the yarns and what a data sheet says of the fabric, if
       * they are asked for. @note Collective. */
      void
      measure_yarns(const Place &place);

      /** If it is asked for. @note Collective. */
      void
      write_centerlines() const;

      /** Where the time went since the program was started. */
      IO::WallTime
      clock() const;

      void
      update_times();

      void
      write_summary();

      void
      save(ArchiveWriter &archive, const Place &place) const;

      void
      load_summary(const ArchiveReader &archive);

      Scene               &scene;
      const Parameters    &parameters;
      const ParameterFile &file;
      const std::string    directory;
      const std::string    in_force; /**< all parameters, see settings_text() */

      /** The file of the initial configuration that is given, or empty. */
      const std::string given_configuration;
      SectionTimer     &timer;
      const bool        first_rank;
      IO::Summary       summary;
      IO::History       history;
      IO::Checkpoint    checkpoint;
      EnergyBalance     balance;
      std::string       overfull;

      Contributions::Indentation         deepest;
      std::unique_ptr<IO::FiberOutput>   fibers;
      std::unique_ptr<IO::ContactOutput> contacts;
      std::unique_ptr<IO::MatrixOutput>  matrix;
      std::unique_ptr<IO::PlateOutput>   plates;

      /** Wall times of the stage before this run, and of the run before it. */
      IO::WallTime earlier;
      IO::WallTime at_begin;
    };
  } // namespace Simulation
} // namespace Heddle

#endif
