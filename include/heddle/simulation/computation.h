#ifndef heddle_simulation_computation_h
#define heddle_simulation_computation_h

#include <heddle/base/log.h>
#include <heddle/base/signals.h>
#include <heddle/simulation/recorder.h>

#include <memory>
#include <vector>

namespace Heddle
{
  namespace Simulation
  {
    /** Takes a scene through its stages, step by step. */
    class Computation
    {
    public:
      /** The folder of @p recorder exists. */
      Computation(Scene            &scene,
                  const Parameters &parameters,
                  Recorder         &recorder,
                  Log              &log,
                  SectionTimer     &timer,
                  StopRequest      &stop);

      /**
       * From the start, or from the checkpoint that was read. Throws
       * NotConverged or Stopped after the last good state was saved.
       * @note Collective.
       */
      void
      run();

      /**
       * Read the last checkpoint; writes nothing. Throws InputError if this
       * scene cannot go on from it.
       * @note Collective.
       */
      void
      read_checkpoint();

    private:
      /** Look for contacts in the state as it is, as its last step did. */
      void
      update_contacts();

      /**
       * Write how the run ends, if that can be written: what is saved next may
       * find the disk full.
       */
      void
      tell(const IO::Status status, const std::string &why);

      /** No equilibrium was found: see that the last one is kept. */
      void
      keep_last_step();

      void
      run_stages();

      void
      begin_stage(const Stage &stage);

      void
      run_stage();

      /** Say what is to be said of it; throw NotConverged if it has led to what
       * it must not. */
      void
      end_stage(const Stage &stage);

      void
      end_loading(const Stage &stage) const;

      /**
       * After one that led to no equilibrium: a shorter one or, if there is
       * none, once more the whole one with more iterations. Throw NotConverged
       * if that was in vain.
       */
      void
      try_another_step(const Stage &stage, const Solver::NewtonResult &result);

      /** Set out for the next load factor; return what came of it. */
      Solver::NewtonResult
      try_step(const Stage &stage);

      /** Equilibrium that holds when all contact is searched anew. */
      Solver::NewtonResult
      equilibrate(const Stage &stage);

      void
      accept(const Stage &stage, const Solver::NewtonResult &result);

      void
      reject(const Stage &stage);

      void
      show_status(const Stage &stage, const double load_factor);

      /** Say whether fibers take more than there is of a yarn. */
      void
      tell_overfull_yarns() const;

      /** What is to be said of a fiber that is bent too sharply, by itself or
       * around another one, or nothing. */
      std::string
      bend_in_words() const;

      /** "stage settle, step 3 to load factor 0.5" */
      std::string
      place_in_words() const;

      Scene                                             &scene;
      const Parameters                                  &parameters;
      Recorder                                          &recorder;
      Log                                               &log;
      SectionTimer                                      &timer;
      StopRequest                                       &stop;
      Solver::NewtonLimits                               limits;
      Solver::Newton                                     newton;
      std::vector<std::unique_ptr<Solver::LoadStepping>> stepping;
      Recorder::Place                                    place;
      double                                             stage_began    = 0.;
      double                                             stage_began_at = 0.;
      bool                                               bend_is_told   = false;
    };
  } // namespace Simulation
} // namespace Heddle

#endif
