#include <heddle/base/exceptions.h>
#include <heddle/base/freed_memory.h>
#include <heddle/solver/motion_in_parts.h>
#include <heddle/solver/newton_search.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /**
       * An iteration is calm if it moves no fiber further than @p motion, in
       * radii, and their nodes by @p mean_motion on average, and forces balance
       * on average to @p mean_ratio. Nonsmooth terms then keep the part
       * @p hardening of their softness.
       */
      struct Calm
      {
        double motion, mean_motion, mean_ratio, hardening;
      };

      constexpr Calm before_equilibrium = {0.3, 0.3, 0.1, 0.5};

      /**
       * Where friction is to begin there is no need to wait for the last
       * fibers: it holds those that are still on their way. That saves a third
       * of the iterations of the paper's fabrics. But forces have to balance on
       * average: where friction began before, 5 of 24 small fabrics ended with
       * 1.4 % less force than the others (doc/what_was_tried.md). They do so
       * from the start where yarns are loose and pulled hard: as long as yarns
       * move as a whole, by 0.2 R and more, friction is not to hold them.
       */
      constexpr Calm before_friction = {0.6, 0.15, 0.6, 0.25};

      const Calm &
      calmness(const Aim aim)
      {
        return aim == Aim::calm_from_start ? before_friction
                                           : before_equilibrium;
      }

      /** Nonsmooth terms are softened from this mean residual ratio on, ... */
      constexpr double unsettled = 1.;

      /** ... and this is the least softness before none. */
      constexpr double least_softness = 0.02;

      /** Penalties are judged no sooner than so many iterations after a change.
       */
      constexpr unsigned int patience = 4;

      /** Iterations at rest, one after the other, to which a term objects. */
      constexpr unsigned int most_objections = 5;

      /**
       * Where fibers touch forces fall when they are, on average, below this
       * part in one of so many iterations of what they were in all of as many
       * before. A strand of 19 wires takes 112 iterations for a step, and none
       * of its halves was found in 60 (tests/application/loose_strand).
       */
      constexpr double       falling_part   = 0.7;
      constexpr unsigned int falling_window = 20;

      /** Whole steps after which a search without contact is held back. */
      constexpr unsigned int most_unguarded = 30;

      /** Of the residual that is accepted elsewhere, where the equilibrium is
       * not stable. */
      constexpr double on_saddle = 1e-3;

      /** Blocks of a rank from which on their memory is worth giving back. */
      constexpr unsigned int much_memory = 10000;
    } // namespace



    NewtonTools::NewtonTools(const System::State          &state,
                             const LinearSolverParameters &linear_parameters,
                             const double                  first_damping)
      // What is factorized has to be in the matrix. Where nothing is in contact
      // a system may be factorized nevertheless: nothing couples fibers then.
      : system(state,
               /*couplings_apart=*/
               !linear_parameters.direct(state.n_dofs(),
                                         /*contact=*/true,
                                         /*matrix=*/state.matrix() != nullptr))
      , linear_solver(linear_parameters, system)
      , damping(state.space, first_damping)
    {
    }



    void
    NewtonTools::give_memory_back()
    {
      // Giving it back, and taking it again, is 3 to 10 % of a run of short
      // steps where there is little of it.
      if (system.state.n_owned_blocks() < much_memory)
        return;
      system.forget_couplings();
      linear_solver.forget();
      secants.forget();
      return_freed_memory();
    }



    NewtonSearch::NewtonSearch(Equations          &equations,
                               NewtonTools        &tools,
                               const NewtonLimits &limits,
                               const Aim           aim,
                               Log                &log,
                               SectionTimer       &timer,
                               StopRequest        &stop)
      : equations(equations)
      , tools(tools)
      , limits(limits)
      , aim(aim)
      , log(log)
      , timer(timer)
      , stop(stop)
      , limit(equations.state.load_factor == 0. ? limits.most_iterations
                                                : limits.max_iterations)
    {
    }



    NewtonResult
    NewtonSearch::run(const System::Increment &guess)
    {
      tools.secants.forget();
      tools.damping.reset(/*in_motion=*/false);
      equations.set_softness(0.);
      equations.set_geometric_stiffness(false);
      {
        SectionTimer::Scope scope(timer, "detection");
        guessed = follow(equations, guess, stop);
      }
      start = equations.state.current();

      for (;; ++iteration)
        {
          if (stop.received())
            throw Stopped("stopped by " + stop.reason());
          measure();
          report();
          const Verdict verdict = judge();
          if (verdict == Verdict::ended)
            return result;
          if (verdict == Verdict::begin_again)
            continue;
          harden_or_adapt();
          find_increment();
          if (!take_step())
            return result;
        }
    }



    void
    NewtonSearch::measure()
    {
      evaluate();
      nonsmooth = equations.is_nonsmooth();
      if (nonsmooth)
        tools.damping.end_alone();
      if (nonsmooth && wants_softness())
        {
          equations.set_softness(1.);
          tools.damping.reset(/*in_motion=*/true);
          evaluate();
        }
      calm = nonsmooth && iteration > 0 &&
             result.increment < calmness(aim).motion &&
             mean_motion() < calmness(aim).mean_motion &&
             residual.mean_ratio < calmness(aim).mean_ratio;
      mean_forces.push_back(residual.mean_force);
      result.residual_ratio = residual.ratio;
      result.iterations     = iteration;
    }



    bool
    NewtonSearch::wants_softness() const
    {
      switch (aim)
        {
          case Aim::calm_from_start:
          case Aim::equilibrium_from_start:
            return !softened && equations.softness() == 0.;
          case Aim::equilibrium:
            return iteration == 0 && !guessed &&
                   residual.mean_ratio >= unsettled;
          case Aim::equilibrium_after_calm:
            return false;
        }
      return false;
    }



    void
    NewtonSearch::evaluate()
    {
      equations.prepare();
      equations.assemble();
      residual = equations.judge();
    }



    void
    NewtonSearch::renew()
    {
      equations.prepare();
      equations.assemble();
      adapted_at = iteration;
      mean_forces.clear();
    }



    NewtonSearch::Verdict
    NewtonSearch::judge()
    {
      if (!std::isfinite(residual.largest_force))
        {
          result.obstacle =
            "the force on " +
            largest_imbalance(equations.system, equations.contributions) +
            " is no finite number";
          return Verdict::ended;
        }
      if (aim == Aim::calm_from_start && equations.softness() == 0. && calm)
        {
          result.converged = true;
          return Verdict::ended;
        }

      // Where all forces are last digits a step that is cut says nothing.
      const bool still =
        (iteration > 0 && (residual.ratio > 0. ? result.increment : wanted) <=
                            limits.increment_tolerance) ||
        residual.largest_force == 0.;

      // Equilibrium counts only if it holds for what is guessed better, and if
      // no term objects to it.
      bool balanced = is_balanced();
      if (balanced && still && equations.adapt())
        {
          renew();
          residual              = equations.judge();
          result.residual_ratio = residual.ratio;
          balanced              = is_balanced();
        }
      result.obstacle = balanced && still ? equations.objection() : "";
      if (!balanced || !still || !result.obstacle.empty())
        return judge_progress(balanced, still);

      // In a matrix fibers buckle in waves as short as hexahedra allow, all at
      // once: that is told, and not followed. The tangent of the first
      // iteration is still that of the step before.
      result.unstable = !nonsmooth &&
                        (guarded || linear.indefinite || iteration == 1) &&
                        is_unstable();
      if (result.unstable && !guarded && !equations.state.matrix())
        {
          begin_again("not stable");
          return Verdict::begin_again;
        }

      // On its way off a saddle a column hardly moves at first, and what drives
      // it may be less than is accepted. Where nothing does forces vanish.
      if (result.unstable && guarded && !equations.state.matrix() &&
          iteration < limit &&
          residual.ratio > on_saddle * limits.residual_tolerance)
        {
          equations.assemble();
          n_objections = 0;
          return Verdict::go_on;
        }
      for (const auto &contribution : equations.contributions)
        contribution->observe(equations.system);
      result.converged = true;
      return Verdict::ended;
    }



    NewtonSearch::Verdict
    NewtonSearch::judge_progress(const bool balanced, const bool still)
    {
      // What is at rest, and stays so, no iteration mends.
      n_objections = result.obstacle.empty() || adapted_at == iteration
                       ? 0
                       : n_objections + 1;
      if (n_objections == most_objections)
        return Verdict::ended;
      if (iteration == limit && limit < limits.most_iterations && nonsmooth &&
          forces_fall())
        limit = std::min(limit + falling_window, limits.most_iterations);
      if (iteration == limit)
        {
          result.used_up = true;
          if (residual.ratio <= limits.residual_tolerance && !is_in_place())
            result.obstacle = not_arrived;
          else if (!balanced)
            result.obstacle = describe_imbalance();
          else if (!still)
            result.obstacle = "the fibers still move";
          return Verdict::ended;
        }

      // Without bounds Newton's method goes to and fro where a structure snaps
      // through: held back, its energy falls.
      if (n_whole == most_unguarded && !nonsmooth && !guarded &&
          !linear.unsymmetric && !equations.state.matrix())
        {
          begin_again("no equilibrium in sight");
          return Verdict::begin_again;
        }
      return Verdict::go_on;
    }



    void
    NewtonSearch::begin_again(const std::string &reason)
    {
      log << "  " << reason << ": from the start, held back" << std::endl;
      // Ghosts may have come and gone since.
      equations.state.set_owned(start);
      for (const auto &contribution : equations.contributions)
        contribution->begin_step(equations.state);
      tools.damping.reset_alone();
      guarded = true;
      mean_forces.clear();
      limit += result.iterations;
    }



    bool
    NewtonSearch::forces_fall() const
    {
      // Where terms have adapted meanwhile there is nothing to compare with.
      const auto n = mean_forces.size();
      if (n < 2 * falling_window)
        return true;
      const auto recent = mean_forces.end() - falling_window;
      return *std::min_element(recent, mean_forces.end()) <
             falling_part * *std::min_element(recent - falling_window, recent);
    }



    bool
    NewtonSearch::is_balanced() const
    {
      return equations.softness() == 0. && is_in_place() &&
             residual.ratio <= limits.residual_tolerance;
    }



    bool
    NewtonSearch::is_unstable()
    {
      // Motions that nothing resists, such as the turn of a fiber about the
      // line through its ends, have pivots of round-off and of what balances
      // not quite, of either sign.
      equations.assemble();
      tools.damping.add_uncertainty_to(
        equations.system, equations.state, residual.largest_force);
      equations.system.end();
      const bool unstable = tools.linear_solver.solve().indefinite;
      equations.assemble(System::BlockSystem::Want::residual);
      return unstable;
    }



    void
    NewtonSearch::harden_or_adapt()
    {
      if (!calm)
        return;
      const double softness = equations.softness();
      if (softness > 0.)
        {
          equations.adapt();
          const double next = calmness(aim).hardening * softness;
          equations.set_softness(next > least_softness ? next : 0.);
          renew();
        }
      else if (iteration >=
                 (guessed && adapted_at == 0 ? 1 : adapted_at + patience) &&
               equations.adapt())
        renew();
    }



    std::string
    NewtonSearch::describe_imbalance() const
    {
      std::ostringstream text;
      text << std::setprecision(3)
           << "forces are not in balance, the largest unbalanced one is "
           << residual.ratio << " times what is typical ("
           << limits.residual_tolerance << " is accepted) and acts on "
           << largest_imbalance(equations.system, equations.contributions)
           << "; the last iteration moved fibers by up to " << result.increment
           << " radii";
      return text.str();
    }



    void
    NewtonSearch::report() const
    {
      log << "  newton " << std::setw(3) << iteration << std::scientific
          << std::setprecision(1) << "  residual " << residual.ratio;
      if (equations.state.matrix())
        log << "  matrix " << residual.matrix_ratio;
      if (iteration > 0)
        log << "  increment " << result.increment;
      if (equations.softness() > 0.)
        log << "  softness " << equations.softness();
      for (const auto &contribution : equations.contributions)
        if (!contribution->status().empty())
          log << "  " << contribution->status();
      log << std::endl;
    }
  } // namespace Solver
} // namespace Heddle
