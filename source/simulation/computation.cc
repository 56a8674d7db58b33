#include <heddle/base/exceptions.h>
#include <heddle/post/bend.h>
#include <heddle/simulation/computation.h>
#include <heddle/simulation/matrix.h>
#include <heddle/simulation/scene_notes.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace Heddle
{
  namespace Simulation
  {
    namespace
    {
      /** Fresh searches after which a step is given up. */
      constexpr unsigned int n_searches = 4;

      /** A step to where nothing is stable is halved so many times. */
      constexpr unsigned int most_jumps = 4;

      bool
      has_sections(const Parameters &parameters)
      {
        return parameters.fiber.element_kind == Beam::ElementKind::director;
      }



      /** Curved fibers without torsion cannot begin free of stress. */
      std::string
      begin_free_of_stress(const Parameters &parameters)
      {
        return std::string("set Restart/Stress free") +
               (has_sections(parameters) ? ""
                                         : ", with Fiber/Element = director");
      }



      /** Why a fabric may find no equilibrium before anything moves. */
      std::string
      loose_ends(const Parameters &parameters)
      {
        return "at load factor 0 the guides and the tension of the initial "
               "configuration are gone, and yarns shrink and slip whose ends "
               "no support holds: hold these, across too, or load each of "
               "their fibers by its tension, Initial configuration/Axial "
               "tension times its E A, or " +
               begin_free_of_stress(parameters);
      }



      /**
       * The same of a test, which has supports of its own. Friction spins
       * fibers, also those that stand for many filaments, which next to nothing
       * resists.
       */
      std::string
      let_go(const Parameters &parameters)
      {
        return "at load factor 0 the guides of the initial configuration are "
               "gone, and its tension where a test lets go of yarns: give less "
               "Initial configuration/Axial tension, or " +
               begin_free_of_stress(parameters) +
               (has_sections(parameters) && parameters.contact.has_friction()
                  ? ", or Fiber/Element = hermite, whose fibers do not spin"
                  : "");
      }



      /**
       * What forces that are the last digits of those by which fibers resist
       * can do as they are turned by their length [N mm]: solved systems have
       * some more digits less.
       */
      double
      round_off_work(const System::FiberSpace &space)
      {
        constexpr double last_digits =
          256. * std::numeric_limits<double>::epsilon();
        double largest = 0.;
        for (unsigned int f = 0; f < space.n_fibers(); ++f)
          largest = std::max(
            largest, space.fiber(f).section.axial * space.fiber(f).length);
        return last_digits * largest;
      }
    } // namespace



    Computation::Computation(Scene            &scene,
                             const Parameters &parameters,
                             Recorder         &recorder,
                             Log              &log,
                             SectionTimer     &timer,
                             StopRequest      &stop)
      : scene(scene)
      , parameters(parameters)
      , recorder(recorder)
      , log(log)
      , timer(timer)
      , stop(stop)
      , limits(parameters.newton)
      , newton(limits, parameters.linear_solver, log, timer, stop)
    {
      for (const Stage &stage : scene.stages())
        stepping.push_back(std::make_unique<Solver::LoadStepping>(stage.plan));
    }



    void
    Computation::run()
    {
      using Status = IO::Status;
      if (place.stepping != nullptr)
        {
          // Only a search tells whether fibers are near each other. A stage
          // that has yet to begin sees to this by itself, and one with its own
          // way has left what it searched.
          if (place.stepping->has_begun() && !scene.stages()[place.stage].solve)
            update_contacts();
          place.crossings =
            scene.count_crossings(scene.stages()[place.stage].flattened);
          recorder.continue_from(place);
          if (recorder.has_ended(place))
            log << "Note           this run has ended: nothing is left to "
                   "compute, and its results stay as they are"
                << std::endl;
        }
      else
        {
          if (!parameters.restart.initial_configuration.empty())
            recorder.read_initial_configuration(log);
          recorder.begin(place);
          if (scene.stages().empty())
            tell_overfull_yarns();
        }
      try
        {
          run_stages();
          recorder.finish(Status::converged, "");
        }
      catch (const NotConverged &error)
        {
          tell(Status::not_converged, error.what());
          keep_last_step();
          recorder.finish(Status::not_converged, error.what());
          throw;
        }
      catch (const Stopped &error)
        {
          tell(Status::stopped, error.what());
          reject(scene.stages()[place.stage]);
          recorder.write_checkpoint(place);
          recorder.finish(Status::stopped, error.what());
          throw;
        }
      catch (const std::exception &error)
        {
          recorder.finish(Status::failed, error.what());
          throw;
        }
    }



    void
    Computation::tell(const IO::Status status, const std::string &why)
    {
      try
        {
          recorder.finish(status, why);
        }
      catch (const std::exception &)
        {
          // It is told once more when the state is saved, which all ranks do.
        }
    }



    void
    Computation::read_checkpoint()
    {
      place = recorder.resume(stepping, log);
      log << "Resumes        stage " << scene.stages()[place.stage].name
          << " after load factor " << std::defaultfloat << std::setprecision(4)
          << place.stepping->reached() << std::endl;
    }



    void
    Computation::update_contacts()
    {
      const Stage &stage = scene.stages()[place.stage];
      stage.set_up(place.stepping->reached());
      for (auto *term : Solver::nonsmooth_terms(stage.contributions))
        term->update(scene.state());
    }



    void
    Computation::keep_last_step()
    {
      // The stage before has ended well, and what follows may be set otherwise.
      if (!place.stepping->has_begun())
        {
          if (place.number > 0 && parameters.output.checkpoint_interval == 0)
            recorder.write_checkpoint(place);
          return;
        }
      // Contact was last looked at where no equilibrium was found.
      update_contacts();
      recorder.keep(place);
    }



    void
    Computation::run_stages()
    {
      const unsigned int n_stages = scene.stages().size();
      for (; place.stage < n_stages; ++place.stage)
        {
          place.stepping = stepping[place.stage].get();
          recorder.begin_stage(place.stage);
          if (!place.stepping->has_begun())
            begin_stage(scene.stages()[place.stage]);
          stage_began    = timer.total();
          stage_began_at = place.stepping->reached();
          run_stage();
        }
      place.stage = std::max(n_stages, 1u) - 1;
    }



    void
    Computation::begin_stage(const Stage &stage)
    {
      place.tries = {};
      newton.begin_stage();
      if (stage.begins_initially)
        recorder.return_to_initial_configuration();
      System::State &state = scene.state();
      state.step           = 0;
      state.load_factor    = 0.;
      stage.begin();
      if (stage.is_loaded() && scene.matrix())
        log << scene.matrix()->in_words() << std::endl;
      for (const auto &contribution : stage.contributions)
        contribution->begin_stage(state);
      if (!stage.is_loaded())
        return;

      // A step of no motion leaves the forces from which work counts.
      stage.set_up(/*load_factor=*/0.);
      for (const auto &contribution : stage.contributions)
        contribution->begin_step(state);
      const double ratio = newton.residual_ratio(state, stage.contributions);
      for (const auto &contribution : stage.contributions)
        {
          contribution->observe(*newton.system());
          contribution->accept_step(state);
        }
      // What was held until now comes to rest before anything moves; the curves
      // of a fabric begin there in any case.
      if (ratio > 0. || scene.is_fabric())
        stepping[place.stage]->begin_at_zero();
      else
        recorder.begin_balance(place.stage);
      // A case before this one tells nothing of it.
      place.predictor.begin(state);
    }



    void
    Computation::run_stage()
    {
      const Stage          &stage = scene.stages()[place.stage];
      Solver::LoadStepping &steps = *stepping[place.stage];
      Recorder::Tries      &tries = place.tries;
      while (!steps.finished())
        {
          Solver::NewtonResult result = try_step(stage);
          recorder.count(place.stage, result);
          if (result.converged)
            place.crossings = scene.count_crossings(stage.flattened);
          if (result.converged && stage.is_loaded())
            {
              result.obstacle  = stage.objection(place.crossings);
              result.converged = result.obstacle.empty();
            }
          // In a matrix what is not stable is not left for what is. It may be
          // that only the step was too long to follow where it bends.
          if (result.converged && result.unstable && scene.matrix() &&
              tries.n_unstable == 0 && tries.n_jumps < most_jumps &&
              steps.cut_back())
            {
              ++tries.n_jumps;
              reject(stage);
              log << "  not stable, as it was until now: the step is halved"
                  << std::endl;
              continue;
            }
          tries.n_jumps = 0;
          if (result.converged)
            {
              tries.takes_longest = false;
              steps.accept(result.iterations);
              accept(stage, result);
            }
          else
            try_another_step(stage, result);
        }
      end_stage(stage);
    }



    void
    Computation::end_stage(const Stage &stage)
    {
      const unsigned int n_unstable = place.tries.n_unstable;
      if (n_unstable > 0)
        log << "Note           " << n_unstable
            << (n_unstable == 1 ? " step" : " steps") << " of stage "
            << stage.name
            << " ended in an equilibrium that is not stable: a small "
               "disturbance, such as a force across, leads to another one"
            << std::endl;
      const std::string objection = stage.objection(place.crossings);
      if (!objection.empty())
        throw NotConverged("Stage " + stage.name + ": " + objection + ".");
      tell_overfull_yarns();
      const std::string bend = bend_in_words();
      if (!bend.empty() && !bend_is_told)
        log << "Note           " << bend << std::endl;
      bend_is_told = bend_is_told || !bend.empty();
      // Where only calm is asked for forces are what they happen to be.
      const std::string indentation = recorder.deepest_indentation().in_words();
      if (!indentation.empty() && !stage.solve &&
          stage.aim != Solver::Aim::calm_from_start)
        log << "Note           of stage " << stage.name << ", " << indentation
            << std::endl;
      if (stage.is_loaded())
        end_loading(stage);
    }



    void
    Computation::end_loading(const Stage &stage) const
    {
      const std::string lost = place.crossings.apart_in_words();
      if (!lost.empty())
        log << "Note           " << lost
            << ": yarns have slipped off the ends of others" << std::endl;
      const std::string imbalance =
        recorder.energy_balance().in_words(round_off_work(scene.space()));
      if (!imbalance.empty())
        log << "Note           of stage " << stage.name << ", " << imbalance
            << std::endl;
      const std::string turned =
        scene.matrix() ? scene.matrix()->turned_in_words(scene.state()) : "";
      if (!turned.empty())
        log << "Note           " << turned << std::endl;
    }



    void
    Computation::tell_overfull_yarns() const
    {
      if (!recorder.overfull_yarns().empty())
        log << "Note           " << recorder.overfull_yarns() << std::endl;
    }



    void
    Computation::try_another_step(const Stage                &stage,
                                  const Solver::NewtonResult &result)
    {
      Solver::LoadStepping &steps   = *stepping[place.stage];
      const bool            at_zero = scene.state().load_factor == 0.;
      const bool to_zero = scene.is_fabric() && stage.is_loaded() && at_zero;
      const std::string where = place_in_words();
      const std::string jam =
        scene.contact() ? scene.contact()->jam_in_words() : "";
      const std::string hint = jam.empty() ? bend_in_words() : jam;
      const std::string why =
        result.obstacle + (hint.empty() ? "" : "; " + hint);
      reject(stage);
      if (!place.tries.takes_longest && steps.cut_back())
        {
          log << "  not converged: " << why << "; the step is halved"
              << std::endl;
          return;
        }

      // The way of a snap is no shorter in a shorter step: what is left is to
      // go along it for longer, as a step to load factor 0 has done.
      if (!at_zero && result.used_up &&
          limits.max_iterations < limits.most_iterations)
        {
          place.tries.takes_longest = true;
          steps.restore();
          log << "  not converged: " << why << "; the whole step gets "
              << limits.most_iterations << " iterations" << std::endl;
          return;
        }
      const std::string advice = !to_zero ? missing_torsion(scene, parameters)
                                 : parameters.fabric_loading.is_active()
                                   ? let_go(parameters)
                                   : loose_ends(parameters);
      throw NotConverged(
        "No equilibrium in " + where + " after " +
        std::to_string(result.iterations) + " iterations" +
        (result.used_up ? ", as many as Newton/Maximum iterations allows for a "
                          "search"
                        : "") +
        ": " + why + (advice.empty() ? "" : "; " + advice) + ".");
    }



    Solver::NewtonResult
    Computation::try_step(const Stage &stage)
    {
      System::State &state  = scene.state();
      state.load_factor     = stepping[place.stage]->next();
      limits.max_iterations = place.tries.takes_longest
                                ? limits.most_iterations
                                : parameters.newton.max_iterations;
      if (state.load_factor > 0.)
        ++state.step;
      log << "Stage " << stage.name << ", step " << state.step
          << ": load factor " << std::defaultfloat << std::setprecision(4)
          << state.load_factor << std::endl;
      show_status(stage, state.load_factor);
      stage.set_up(state.load_factor);
      return stage.solve ? stage.solve(log, timer, stop) : equilibrate(stage);
    }



    Solver::NewtonResult
    Computation::equilibrate(const Stage &stage)
    {
      const Solver::Contributions &contributions = stage.contributions;
      System::State               &state         = scene.state();
      Solver::NewtonResult         total;
      for (unsigned int i = 0; i < n_searches && !total.converged; ++i)
        {
          for (const auto &contribution : contributions)
            contribution->begin_step(state);
          // Only the first search of a stage begins where fibers start.
          const bool        predicts = stage.is_loaded() && i == 0;
          const Solver::Aim aim =
            stage.aim == Solver::Aim::equilibrium_from_start &&
                (i > 0 || stepping[place.stage]->reached() > 0.)
              ? Solver::Aim::equilibrium
              : stage.aim;
          const Solver::NewtonResult result = newton.solve(
            state,
            contributions,
            aim,
            predicts ? place.predictor.guess(state) : System::Increment());
          total.iterations += result.iterations;
          total.factorizations += result.factorizations;
          total.linear_iterations += result.linear_iterations;
          total.residual_ratio = result.residual_ratio;
          total.obstacle       = result.obstacle;
          total.converged      = result.converged;
          total.used_up        = result.used_up;
          total.unstable       = result.unstable;

          // Only now is it known whether fibers came near each other.
          if (!result.converged || aim == Solver::Aim::calm_from_start ||
              !Solver::is_nonsmooth(Solver::nonsmooth_terms(contributions)))
            return total;

          for (const auto &contribution : contributions)
            contribution->begin_step(state);
          total.residual_ratio = newton.residual_ratio(state, contributions);
          if (total.residual_ratio > parameters.newton.residual_tolerance)
            total.obstacle = "a new search finds other contacts";
          for (const auto &contribution : contributions)
            if (total.obstacle.empty())
              total.obstacle = contribution->objection(state);
          total.converged = total.obstacle.empty();
          // Reactions belong to the forces that are found in the end.
          if (total.converged)
            for (const auto &contribution : contributions)
              contribution->observe(*newton.system());
        }
      return total;
    }



    void
    Computation::accept(const Stage &stage, const Solver::NewtonResult &result)
    {
      for (const auto &contribution : stage.contributions)
        contribution->accept_step(scene.state());
      scene.state().accept();
      // Motion to load factor 0 tells nothing of that with the load.
      if (scene.state().load_factor == 0.)
        place.predictor.begin(scene.state());
      else if (stage.is_loaded())
        place.predictor.add(scene.state());
      ++place.number;
      log << "  converged after " << result.iterations << " iterations";
      if (!std::isnan(result.residual_ratio))
        log << ", residual " << std::scientific << std::setprecision(1)
            << result.residual_ratio;
      if (result.unstable)
        {
          log << "; not stable";
          ++place.tries.n_unstable;
        }
      log << std::endl;
      recorder.add_step(place, result);
    }



    void
    Computation::reject(const Stage &stage)
    {
      System::State &state = scene.state();
      state.reject();
      state.load_factor = stepping[place.stage]->reached();
      if (state.step > 0)
        --state.step;
      for (const auto &contribution : stage.contributions)
        contribution->reject_step(state);
    }



    void
    Computation::show_status(const Stage &stage, const double load_factor)
    {
      if (!parameters.run.timing)
        return;
      std::ostringstream text;
      text << "stage " << stage.name << " at load factor "
           << stepping[place.stage]->reached() << ", on the way to "
           << load_factor << ", " << std::lround(timer.total()) << " s";
      const double done = stepping[place.stage]->reached() - stage_began_at;
      if (done > 0.)
        text << ", about "
             << std::lround((timer.total() - stage_began) *
                            (1. - stage_began_at - done) / done)
             << " s to go in this stage";
      log.status(text.str());
    }



    std::string
    Computation::bend_in_words() const
    {
      const std::string advice =
        ": thinner fibers are bent less, and those of a larger Fiber/Shear "
        "stiffness or Fiber/Bending stiffness";
      const Post::Bend bend = Post::sharpest_bend(scene.state());
      if (bend.is_a_kink())
        return bend.in_words() + ", where it is no beam" +
               (parameters.contact.enabled ? " and its contacts are not unique"
                                           : "") +
               advice;
      if (!scene.contact())
        return "";
      const Post::BentContact contact = Post::tightest_contact(
        scene.space(), scene.contact()->curves(), scene.contact()->elements());
      if (!contact.is_tight())
        return "";
      return contact.in_words() +
             ": bent so sharply around each other, other particles face each "
             "other after little motion, and forces may jump" +
             advice;
    }



    std::string
    Computation::place_in_words() const
    {
      std::ostringstream text;
      text << "stage " << scene.stages()[place.stage].name << ", step "
           << scene.state().step << " to load factor "
           << scene.state().load_factor;
      return text.str();
    }
  } // namespace Simulation
} // namespace Heddle
