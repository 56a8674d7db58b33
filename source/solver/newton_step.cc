// How a search finds the increment of an iteration, and how much of it is
// taken.
#include <heddle/solver/fiber_spin.h>
#include <heddle/solver/force_search.h>
#include <heddle/solver/motion_in_parts.h>
#include <heddle/solver/newton_search.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /**
       * Before friction linear systems need not be solved as well as usual: a
       * tolerance so many times looser saves a tenth of the time of the paper's
       * fabrics, at as many iterations (doc/what_was_tried.md). Where no
       * friction follows it takes more of them.
       */
      constexpr double looser_before_friction = 3.;

      /** No step is stretched so that a fiber moves further, in radii. */
      constexpr double longest_stretched_motion = 0.5;

      /** What is prescribed does not come about by steps shorter than this. */
      constexpr double least_part_of_step = 1e-6;

      /** Prescribed motion that is little, in radii, is searched ... */
      constexpr double little = 0.01;

      /** ... in so many iterations in a row. */
      constexpr unsigned int most_searched = 3;

      /**
       * Iterations before what steps tell of the stiffness is made use of: few
       * searches take more, and where fibers find their places, as while they
       * are put in order, it leads astray (doc/what_was_tried.md).
       */
      constexpr unsigned int most_without_secants = 10;

      /**
       * With friction, whose terms are not symmetric, they are of use only
       * where these do not count, and needed only where so many steps in a row
       * were cut to less than this part (doc/what_was_tried.md).
       */
      constexpr unsigned int most_cut = 5;
      constexpr double       much_cut = 0.5;

      /**
       * Iterations of a search before the forces of contact turn in the
       * tangent, and the largest motion in the last one, in radii, and mean
       * residual ratio. Further from equilibrium, by motion or by forces, what
       * makes them slide makes them slide too far.
       */
      constexpr unsigned int most_without_geometric = 5;
      constexpr double       near_rest              = 0.01;
      constexpr double       near_mean_balance      = 0.1;
    } // namespace



    void
    NewtonSearch::find_increment()
    {
      // An iteration in which forces turned in vain is followed by one in
      // which they do not.
      geometric = nonsmooth && is_in_place() && equations.softness() == 0. &&
                  may_be_geometric && iteration >= most_without_geometric &&
                  result.increment < near_rest &&
                  residual.mean_ratio < near_mean_balance &&
                  !(geometric && residual.ratio > ratio_before);
      ratio_before = residual.ratio;
      if (geometric)
        {
          equations.set_geometric_stiffness(true);
          equations.assemble();
        }
      solve_linear_system();
      if (geometric && (linear.singular || linear.indefinite ||
                        LineSearch::slope(equations.system, increment) > 0.))
        {
          may_be_geometric = geometric = false;
          equations.set_geometric_stiffness(false);
          equations.assemble();
          solve_linear_system();
        }
    }



    bool
    NewtonSearch::may_learn() const
    {
      // Steps tell of the stiffness of the terms as they are, and nothing of
      // use as long as fibers find their places. Friction is not the derivative
      // of an energy, as secants have it.
      if (!nonsmooth || !is_in_place() || softened ||
          iteration < most_without_secants)
        return false;
      return !equations.system.has_unsymmetric_terms() ||
             (linear.nearly_symmetric && (learning || n_cut >= most_cut));
    }



    void
    NewtonSearch::solve_linear_system()
    {
      SectionTimer::Scope scope(timer, "linear solver");
      if (is_held())
        tools.damping.add_to(equations.system, equations.state);
      equations.system.end();

      softened = softened || equations.softness() > 0.;
      if (adapted_at == iteration)
        tools.secants.forget();
      learning = may_learn();
      if (learning)
        {
          tools.secants.observe(equations.system.right_hand_side());
          tools.secants.reduce(equations.system.right_hand_side());
        }
      else
        tools.secants.forget();

      // Damping mends what is not positive definite, where there is any.
      // What is not found of how yarns move damps them while surfaces are
      // soft: the plain weave comes near in 45 instead of 52 iterations.
      // Without it after that 576 fibers take 135 instead of 86
      // (doc/what_was_tried.md).
      LinearTask task;
      task.exactly      = !nonsmooth;
      task.yarn_motions = !nonsmooth || equations.softness() == 0.;
      task.looser = aim == Aim::calm_from_start ? looser_before_friction : 1.;
      linear      = tools.linear_solver.solve(task);
      result.linear_iterations += linear.iterations;
      result.factorizations += linear.factorizations;
      if (learning)
        tools.secants.complete(equations.system.right_hand_side(),
                               equations.system.solution());
      equations.system.extract_increment(increment);
      if (nonsmooth && is_in_place() &&
          !equations.system.has_unsymmetric_terms() &&
          limit_spin(equations.state, increment))
        equations.system.replace_increment(increment);
    }



    bool
    NewtonSearch::take_step()
    {
      // Chance makes a tangent that is not positive definite singular.
      if (linear.singular && is_held() && tools.damping.raise())
        {
          // How far fibers have to move is not known.
          result.increment = std::numeric_limits<double>::infinity();
          return true;
        }
      const double motion = largest_motion();
      wanted              = motion;
      if (linear.singular || !std::isfinite(motion))
        {
          result.obstacle = "the linear system is singular: a fiber may be "
                            "free to move without resistance";
          return false;
        }

      // Prescribed motion may well raise the energy, where it drives the step
      // and not what is left of it after a guess. What little is left of it is
      // not searched for long: a search that cuts the step again and again
      // would never get there.
      const double pending = residual.pending / equations.length_scale;
      const bool   search =
        is_held() && n_pending < most_searched &&
        LineSearch::driven_by_forces(equations.system, increment);
      n_pending = !is_in_place() && pending < little ? n_pending + 1 : 0;

      // A tangent that is not positive definite may lead uphill, away from
      // equilibrium: fibers are held back until it does not. What is far from
      // symmetric has no energy.
      if (search && !linear.unsymmetric &&
          (LineSearch::slope(equations.system, increment) > 0. ||
           (guarded && linear.indefinite)) &&
          tools.damping.raise())
        {
          result.increment = motion;
          return true;
        }

      const double longest =
        is_in_place() ? std::max(1., longest_stretched_motion / motion) : 1.;
      const double taken = step_length(longest, search);
      equations.set_geometric_stiffness(false);
      if (!is_in_place() && taken < least_part_of_step)
        {
          result.obstacle = not_arrived;
          return false;
        }
      if (is_held())
        tools.damping.adapt(
          equations.state, increment, taken, equations.length_scale);
      for (Tensor<1, 3> &motion_of_block : increment)
        motion_of_block *= taken;
      n_whole += taken < 1. ? 0 : 1;
      n_cut = taken < much_cut ? n_cut + 1 : 0;
      tools.secants.take(taken, equations.system.solution());
      for (const auto &contribution : equations.contributions)
        contribution->predict(equations.state, increment);
      equations.state.move(1., increment);
      result.increment = taken * motion;
      return true;
    }



    double
    NewtonSearch::step_length(const double longest, const bool search)
    {
      if (!is_held())
        {
          SectionTimer::Scope scope(timer, "detection");
          return walk(equations, increment);
        }

      SectionTimer::Scope scope(timer, "line search");
      const double        largest = std::min(equations.largest_step(increment),
                                      equations.searched_step(increment));
      if (!search)
        return std::min(1., largest);
      if (linear.unsymmetric)
        {
          const double part = step_to_balance(equations.state,
                                              equations.contributions,
                                              equations.system,
                                              tools.linear_solver,
                                              increment,
                                              largest);
          if (part > 0.)
            return part;
        }

      // What is prescribed is no unknown, and not damped.
      System::Increment of_unknowns = increment;
      equations.system.constraints().turn_into_frames(of_unknowns);
      equations.system.constraints().clear_fixed(of_unknowns);
      const double held = Utilities::MPI::sum(
        tools.damping.curvature(equations.state, of_unknowns),
        equations.communicator);
      LineSearch along(equations.state,
                       equations.nonsmooth,
                       equations.system,
                       increment,
                       held);
      return along.best_step(std::min(largest, longest));
    }



    double
    NewtonSearch::mean_motion() const
    {
      const System::State &state = equations.state;
      double               sum = 0., n = 0.;
      for (unsigned int b = 0; b < state.n_owned_fiber_blocks();
           b += state.space.n_blocks_per_node(), n += 1.)
        sum += increment[b].norm_square();
      return std::sqrt(Utilities::MPI::sum(sum, equations.communicator) /
                       Utilities::MPI::sum(n, equations.communicator)) /
             equations.length_scale;
    }



    double
    NewtonSearch::largest_motion() const
    {
      const System::State &state    = equations.state;
      double               largest  = 0.;
      const auto           consider = [&](const unsigned int block) {
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
      return Utilities::MPI::max(largest, equations.communicator) /
             equations.length_scale;
    }
  } // namespace Solver
} // namespace Heddle
