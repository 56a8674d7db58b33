#include <heddle/base/exceptions.h>
#include <heddle/solver/force_search.h>
#include <heddle/solver/newton.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /**
       * An iteration is calm if it moves no fiber further than @p motion, in
       * radii, and forces balance on average to @p mean_ratio. Rough terms then
       * keep the part @p hardening of their softness.
       */
      struct Calm
      {
        double motion, mean_ratio, hardening;
      };

      constexpr Calm before_equilibrium = {0.3, 0.1, 0.5};

      /**
       * Where friction is to begin there is no need to wait for the last
       * fibers: it holds those that are still on their way. That saves a third
       * of the iterations of the paper's fabrics. But forces have to balance on
       * average: where friction began before, 5 of 24 small fabrics ended with
       * 1.4 % less force than the others (doc/what_was_tried.md).
       */
      constexpr Calm before_friction = {0.6, 0.6, 0.25};

      /**
       * Nor need linear systems be solved as well: a tolerance so many times
       * looser saves a tenth of the time of the paper's fabrics, at as many
       * iterations (doc/what_was_tried.md). Where no friction follows it takes
       * more of them.
       */
      constexpr double looser_before_friction = 3.;

      /** Rough terms are softened from this mean residual ratio on, ... */
      constexpr double unsettled = 1.;

      /** ... and this is the least softness before none. */
      constexpr double least_softness = 0.02;

      /** Penalties are judged no sooner than so many iterations after a change.
       */
      constexpr unsigned int patience = 4;

      /** No step is stretched so that a fiber moves further, in radii. */
      constexpr double longest_stretched_motion = 0.5;

      /** What is prescribed does not come about by steps shorter than this. */
      constexpr double least_part_of_step = 1e-6;

      /** Prescribed motion that is little, in radii, is searched ... */
      constexpr double little = 0.01;

      /** ... in so many iterations in a row. */
      constexpr unsigned int most_searched = 3;

      /** Iterations at rest, one after the other, to which a term objects. */
      constexpr unsigned int most_objections = 5;

      /**
       * Iterations before what steps tell of the stiffness is made use of: few
       * searches take more, and where fibers find their places, as while they
       * are put in order, it leads astray (doc/what_was_tried.md).
       */
      constexpr unsigned int most_without_secants = 10;

      /**
       * Iterations of a search before the forces of contact turn in the
       * tangent, and the largest motion in the last one, in radii. Further from
       * equilibrium, by motion or by forces, what makes them slide makes them
       * slide too far.
       */
      constexpr unsigned int most_unturned = 5;
      constexpr double       near_rest     = 0.01;

      /** Whole steps after which a search without contact is held back. */
      constexpr unsigned int most_unguarded = 30;

      /** Searches of contacts along one step where there is none. */
      constexpr unsigned int most_parts_of_step = 100;

      /** Of motions that count as free, over what holds back entirely [-]. */
      constexpr double least_stiffness = 1e-12;

      const std::string not_arrived =
        "supports do not get to where they are to be: contact, or elements of "
        "fibers or cells of the matrix that would turn inside out, allow short "
        "steps only";
    } // namespace



    Newton::Newton(const NewtonLimits           &parameters,
                   const LinearSolverParameters &linear_parameters,
                   const MPI_Comm                communicator,
                   Log                          &log,
                   SectionTimer                 &timer,
                   StopRequest                  &stop)
      : parameters(parameters)
      , linear_parameters(linear_parameters)
      , communicator(communicator)
      , log(log)
      , timer(timer)
      , stop(stop)
    {
    }



    NewtonResult
    Newton::solve(System::State           &state,
                  const Contributions     &contributions,
                  const Aim                aim,
                  const System::Increment &guess)
    {
      begin(state);
      secants->forget();
      find_negligible_forces(state, contributions);
      const bool        guessed = follow(state, contributions, guess);
      NewtonResult      result;
      LinearResult      linear;
      System::Increment increment;
      double            wanted = 0.; /**< by the last system, in radii */
      unsigned int adapted_at = 0, n_pending = 0, n_objections = 0, n_whole = 0;

      // An equilibrium that is not stable, or that is not in sight, is left for
      // one that is found from the start on, held back as where fibers touch.
      const std::vector<Tensor<1, 3>> start   = state.current();
      bool                            guarded = false, softened = false;
      unsigned int limit = state.load_factor == 0. ? parameters.max_at_zero
                                                   : parameters.max_iterations;
      const auto   begin_again = [&](const std::string &reason) {
        log << "  " << reason << ": from the start, held back" << std::endl;
        state.set(start);
        for (const auto &contribution : contributions)
          contribution->begin_step(state);
        damping->reset(/*in_motion=*/true);
        guarded = true;
        limit += result.iterations;
      };

      // Whether forces may turn in the tangent, and did so in the last
      // iteration.
      bool   may_turn = true, turned = false;
      double ratio_before = 0.;

      const Calm &calmness =
        aim == Aim::calm ? before_friction : before_equilibrium;
      set_softness(contributions, 0.);
      let_forces_turn(contributions, false);
      damping->reset(/*in_motion=*/false);
      for (unsigned int iteration = 0;; ++iteration)
        {
          if (stop.received())
            throw Stopped("stopped by " + stop.reason());
          prepare(state, contributions);
          assemble(state, contributions);
          Residual   residual = judge(contributions);
          const bool rough    = std::any_of(
            contributions.begin(),
            contributions.end(),
            [](const auto &contribution) { return contribution->is_rough(); });
          if (rough && iteration == 0 && !guessed &&
              aim != Aim::equilibrium_after_calm &&
              residual.mean_ratio >= unsettled)
            {
              set_softness(contributions, 1.);
              damping->reset(/*in_motion=*/true);
              prepare(state, contributions);
              assemble(state, contributions);
              residual = judge(contributions);
            }
          result.residual_ratio = residual.ratio;
          result.iterations     = iteration;
          report(iteration, residual, result, contributions);
          if (!std::isfinite(residual.largest_force))
            {
              result.obstacle =
                "the force on " +
                largest_imbalance(*block_system, contributions) +
                " is no finite number";
              return result;
            }

          const bool calm = rough && iteration > 0 &&
                            result.increment < calmness.motion &&
                            residual.mean_ratio < calmness.mean_ratio;
          if (aim == Aim::calm && softness == 0. && (calm || !rough))
            {
              result.converged = true;
              return result;
            }

          // Equilibrium counts only if it holds for what is guessed better,
          // and if no term objects to it.
          bool balanced = is_balanced(residual);
          // Where all forces are last digits a step that is cut says nothing.
          const bool still =
            (iteration > 0 &&
             (residual.ratio > 0. ? result.increment : wanted) <=
               parameters.increment_tolerance) ||
            residual.largest_force == 0.;
          if (balanced && still && adapt(state, contributions))
            {
              prepare(state, contributions);
              assemble(state, contributions);
              residual              = judge(contributions);
              result.residual_ratio = residual.ratio;
              balanced              = is_balanced(residual);
              adapted_at            = iteration;
            }
          result.obstacle =
            balanced && still ? first_objection(state, contributions) : "";
          if (balanced && still && result.obstacle.empty())
            {
              // In a matrix fibers buckle in waves as short as hexahedra allow,
              // all at once: that is told, and not followed.
              result.unstable = !rough && (guarded || linear.indefinite) &&
                                is_unstable(state, contributions);
              if (result.unstable && !guarded && !state.matrix())
                {
                  begin_again("not stable");
                  continue;
                }
              for (const auto &contribution : contributions)
                contribution->observe(*block_system);
              result.converged = true;
              return result;
            }
          // What is at rest, and stays so, no iteration mends.
          n_objections = result.obstacle.empty() || adapted_at == iteration
                           ? 0
                           : n_objections + 1;
          if (n_objections == most_objections)
            return result;
          if (iteration == limit)
            {
              result.used_up = true;
              if (residual.ratio <= parameters.residual_tolerance &&
                  residual.pending > reached * length_scale)
                result.obstacle = not_arrived;
              else if (!balanced)
                result.obstacle = describe_imbalance(
                  contributions, residual.ratio, result.increment);
              else if (!still)
                result.obstacle = "the fibers still move";
              return result;
            }

          // Without bounds Newton's method goes to and fro where a structure
          // snaps through: held back, its energy falls.
          if (n_whole == most_unguarded && !rough && !guarded &&
              !linear.unsymmetric && !state.matrix())
            {
              begin_again("no equilibrium in sight");
              continue;
            }

          if (calm && softness > 0.)
            {
              adapt(state, contributions);
              const double next = calmness.hardening * softness;
              set_softness(contributions, next > least_softness ? next : 0.);
              prepare(state, contributions);
              assemble(state, contributions);
              adapted_at = iteration;
            }
          else if (calm &&
                   iteration >=
                     (guessed && adapted_at == 0 ? 1 : adapted_at + patience) &&
                   adapt(state, contributions))
            {
              prepare(state, contributions);
              assemble(state, contributions);
              adapted_at = iteration;
            }

          const bool held = rough || guarded;
          // Steps tell of the stiffness of the terms as they are, and nothing
          // of use as long as fibers find their places.
          const double pending  = residual.pending / length_scale;
          const bool   in_place = pending <= reached;
          softened              = softened || softness > 0.;
          if (adapted_at == iteration)
            secants->forget();
          const bool learn =
            rough && in_place && !softened && iteration >= most_without_secants;

          // An iteration in which forces turned in vain is followed by one in
          // which they do not.
          turned = rough && in_place && softness == 0. && may_turn &&
                   iteration >= most_unturned && result.increment < near_rest &&
                   residual.mean_ratio < before_equilibrium.mean_ratio &&
                   !(turned && residual.ratio > ratio_before);
          ratio_before = residual.ratio;
          if (turned)
            {
              let_forces_turn(contributions, true);
              assemble(state, contributions);
            }
          for (bool solved = false; !solved;)
            {
              if (held)
                damping->add_to(*block_system, state);
              linear = solve_linear_system(rough, aim, learn, increment);
              result.linear_iterations += linear.iterations;
              result.factorizations += linear.factorizations;
              solved =
                !turned || !(linear.singular || linear.indefinite ||
                             LineSearch::slope(*block_system, increment) > 0.);
              if (!solved)
                {
                  may_turn = turned = false;
                  let_forces_turn(contributions, false);
                  assemble(state, contributions);
                }
            }

          // Chance makes a tangent that is not positive definite singular.
          if (linear.singular && held && damping->raise())
            {
              // How far fibers have to move is not known.
              result.increment = std::numeric_limits<double>::infinity();
              continue;
            }
          const double motion = largest_motion(state, increment);
          wanted              = motion;
          if (linear.singular || !std::isfinite(motion))
            {
              result.obstacle = "the linear system is singular: a fiber may be "
                                "free to move without resistance";
              return result;
            }
          // Prescribed motion may well raise the energy, where it drives the
          // step and not what is left of it after a guess. What little is left
          // of it is not searched for long: a search that cuts the step again
          // and again would never get there.
          const bool search =
            held && n_pending < most_searched &&
            LineSearch::driven_by_forces(*block_system, increment);
          n_pending = pending > reached && pending < little ? n_pending + 1 : 0;

          // A tangent that is not positive definite may lead uphill, away from
          // equilibrium: fibers are held back until it does not. What is far
          // from symmetric has no energy.
          if (search && !linear.unsymmetric &&
              (LineSearch::slope(*block_system, increment) > 0. ||
               (guarded && linear.indefinite)) &&
              damping->raise())
            {
              result.increment = motion;
              continue;
            }

          const double longest =
            in_place ? std::max(1., longest_stretched_motion / motion) : 1.;
          const double taken = held ? step_length(state,
                                                  contributions,
                                                  increment,
                                                  longest,
                                                  search,
                                                  linear.unsymmetric)
                                    : walk(state, contributions, increment);
          let_forces_turn(contributions, false);
          if (!in_place && taken < least_part_of_step)
            {
              result.obstacle = not_arrived;
              return result;
            }
          if (held)
            damping->adapt(state, increment, taken, length_scale);
          for (Tensor<1, 3> &motion_of_block : increment)
            motion_of_block *= taken;
          n_whole += taken < 1. ? 0 : 1;
          secants->take(taken);
          for (const auto &contribution : contributions)
            contribution->predict(state, increment);
          state.move(1., increment);
          result.increment = taken * motion;
        }
    }



    std::string
    Newton::first_objection(const System::State &state,
                            const Contributions &contributions) const
    {
      std::string objection;
      for (const auto &contribution : contributions)
        if (objection.empty())
          objection = contribution->objection(state);
      return objection;
    }



    bool
    Newton::is_unstable(System::State       &state,
                        const Contributions &contributions)
    {
      // Motions that nothing resists, such as the turn of a fiber about the
      // line through its ends, have pivots of round-off, of either sign.
      assemble(state, contributions);
      damping->add_to(*block_system, state, least_stiffness);
      block_system->end();
      const bool unstable = linear_solver->solve(/*exactly=*/true).indefinite;
      assemble(state, contributions, System::BlockSystem::Want::residual);
      return unstable;
    }



    LinearResult
    Newton::solve_linear_system(const bool         rough,
                                const Aim          aim,
                                const bool         learn,
                                System::Increment &increment)
    {
      SectionTimer::Scope scope(timer, "linear solver");
      block_system->end();

      // Friction is not the derivative of an energy, as secants have it.
      const bool with_secants = learn && !block_system->has_unsymmetric_terms();
      if (with_secants)
        {
          secants->observe(block_system->right_hand_side());
          secants->reduce(block_system->right_hand_side());
        }
      else
        secants->forget();

      // Damping mends what is not positive definite, where there is any.
      // What is not found of how yarns move damps them while surfaces are
      // soft: the plain weave comes near in 45 instead of 52 iterations.
      // Without it after that 576 fibers take 135 instead of 86
      // (doc/what_was_tried.md).
      const LinearResult linear =
        linear_solver->solve(!rough,
                             /*yarn_motions=*/!rough || softness == 0.,
                             aim == Aim::calm ? looser_before_friction : 1.);
      if (with_secants)
        secants->complete(block_system->right_hand_side(),
                          block_system->solution());
      block_system->extract_increment(increment);
      return linear;
    }



    void
    Newton::set_softness(const Contributions &contributions, const double value)
    {
      softness = value;
      for (const auto &contribution : contributions)
        contribution->set_softness(value);
    }



    void
    Newton::let_forces_turn(const Contributions &contributions,
                            const bool           wanted)
    {
      for (const auto &contribution : contributions)
        contribution->let_forces_turn(wanted);
    }



    bool
    Newton::adapt(System::State &state, const Contributions &contributions)
    {
      bool changed = false;
      for (const auto &contribution : contributions)
        changed = contribution->adapt(state) || changed;
      return changed;
    }



    bool
    Newton::is_balanced(const Residual &residual) const
    {
      return softness == 0. && residual.pending <= reached * length_scale &&
             residual.ratio <= parameters.residual_tolerance;
    }



    std::string
    Newton::describe_imbalance(const Contributions &contributions,
                               const double         ratio,
                               const double         motion) const
    {
      std::ostringstream text;
      text << std::setprecision(3)
           << "forces are not in balance, the largest unbalanced one is "
           << ratio << " times what is typical ("
           << parameters.residual_tolerance << " is accepted) and acts on "
           << largest_imbalance(*block_system, contributions)
           << "; the last iteration moved fibers by up to " << motion
           << " radii";
      return text.str();
    }



    double
    Newton::step_length(System::State           &state,
                        const Contributions     &contributions,
                        const System::Increment &increment,
                        const double             longest,
                        const bool               search,
                        const bool               unsymmetric)
    {
      SectionTimer::Scope scope(timer, "line search");
      double              largest = std::numeric_limits<double>::max();
      for (const auto &contribution : contributions)
        largest = std::min({largest,
                            contribution->largest_step(state, increment),
                            contribution->searched_step(state, increment)});
      largest = Utilities::MPI::min(largest, communicator);
      if (!search)
        return std::min(1., largest);
      if (unsymmetric)
        {
          const double part = step_to_balance(state,
                                              contributions,
                                              *block_system,
                                              *linear_solver,
                                              increment,
                                              largest);
          if (part > 0.)
            return part;
        }

      // What is prescribed is no unknown, and not damped.
      System::Increment of_unknowns = increment;
      block_system->constraints().turn_into_frames(of_unknowns);
      block_system->constraints().clear_fixed(of_unknowns);
      const double held = Utilities::MPI::sum(
        damping->curvature(state, of_unknowns), communicator);
      LineSearch along(state, contributions, *block_system, increment, held);
      return along.best_step(std::min(largest, longest));
    }



    double
    Newton::walk(System::State       &state,
                 const Contributions &contributions,
                 System::Increment   &increment)
    {
      SectionTimer::Scope scope(timer, "detection");
      double              whole = 1., taken = 0.;
      for (const auto &contribution : contributions)
        whole = std::min(whole, contribution->largest_step(state, increment));
      whole = Utilities::MPI::min(whole, communicator);
      for (unsigned int i = 0; i < most_parts_of_step; ++i)
        {
          double part = whole - taken;
          for (const auto &contribution : contributions)
            part =
              std::min(part, contribution->searched_step(state, increment));
          part = Utilities::MPI::min(part, communicator);
          state.move(part, increment);
          taken += part;
          if (taken >= whole)
            break;
          bool rough = false;
          for (const auto &contribution : contributions)
            {
              contribution->update(state);
              rough = rough || contribution->is_rough();
            }
          increment.resize(state.n_local_blocks());
          state.update_ghosts(increment);
          if (rough)
            break;
        }
      state.move(-taken, increment);
      return taken;
    }



    double
    Newton::largest_motion(const System::State     &state,
                           const System::Increment &increment) const
    {
      double     largest  = 0.;
      const auto consider = [&](const unsigned int block) {
        const double motion = increment[block].norm();
        // A motion that is not a number is larger than all numbers.
        if (!(motion <= largest))
          largest = std::isnan(motion) ? std::numeric_limits<double>::infinity()
                                       : motion;
      };
      for (unsigned int b = 0; b < state.n_owned_fiber_blocks();
           b += state.space.n_blocks_per_node())
        consider(b);
      for (unsigned int b = state.n_owned_fiber_blocks();
           b < state.n_owned_blocks();
           ++b)
        consider(b);
      return Utilities::MPI::max(largest, communicator) / length_scale;
    }



    void
    Newton::report(const unsigned int   iteration,
                   const Residual      &residual,
                   const NewtonResult  &result,
                   const Contributions &contributions) const
    {
      log << "  newton " << std::setw(3) << iteration << std::scientific
          << std::setprecision(1) << "  residual " << residual.ratio;
      if (block_system->state.matrix())
        log << "  matrix " << residual.matrix_ratio;
      if (iteration > 0)
        log << "  increment " << result.increment;
      if (softness > 0.)
        log << "  softness " << softness;
      for (const auto &contribution : contributions)
        if (!contribution->status().empty())
          log << "  " << contribution->status();
      log << std::endl;
    }
  } // namespace Solver
} // namespace Heddle
