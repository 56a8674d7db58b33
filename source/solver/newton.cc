#include <heddle/base/exceptions.h>
#include <heddle/base/reduce.h>
#include <heddle/solver/newton.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iomanip>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /**
       * Part of the damping that is left at a residual ratio: all above 10, the
       * square root below, and proportional to it below 1, where the iteration
       * would otherwise creep.
       */
      double
      fading(const double ratio)
      {
        constexpr double unsettled = 10.;
        return std::min(
          {1., std::sqrt(ratio / unsettled), ratio / std::sqrt(unsettled)});
      }



      /** A line search ends where the slope is this part of the first one. */
      constexpr double flat = 0.1;

      /** Prescribed motion that is below round-off, in radii. */
      constexpr double reached = 1e-9;

      /** Forces below this part of the axial stiffness are round-off. */
      constexpr double round_off = 1e-13;
    } // namespace



    NewtonParameters::NewtonParameters(const std::string &section)
      : ParameterAcceptor(section)
    {
      add_parameter("Residual tolerance",
                    residual_tolerance,
                    "Largest unbalanced nodal force that is accepted, over the "
                    "mean contact force, or over the largest force where "
                    "nothing touches [-].",
                    prm,
                    Patterns::Double(1e-14, 1.));
      add_parameter("Increment tolerance",
                    increment_tolerance,
                    "Largest motion in the last iteration that is accepted, as "
                    "a multiple of the smallest fiber radius [-].",
                    prm,
                    Patterns::Double(1e-14, 1.));
      add_parameter("Maximum iterations",
                    max_iterations,
                    "Iterations after which a load step is given up [-].",
                    prm,
                    Patterns::Integer(1));
      add_parameter("Damping",
                    damping,
                    "Largest stiffness per length that holds nodes back while "
                    "contact is unsettled, in units of E A / R^2; it fades as "
                    "the iteration calms down. Inactive without contact [-].",
                    prm,
                    Patterns::Double(0.));
    }



    Newton::Newton(const NewtonParameters       &parameters,
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
    Newton::solve(System::State &state, const Contributions &contributions)
    {
      if (!block_system)
        {
          block_system =
            std::make_unique<System::BlockSystem>(state, /*symmetric=*/true);
          linear_solver =
            std::make_unique<LinearSolver>(linear_parameters, *block_system);
          length_scale = state.space.fiber(0).radius;
          for (unsigned int f = 0; f < state.space.n_fibers(); ++f)
            {
              const System::Fiber &fiber = state.space.fiber(f);
              length_scale               = std::min(length_scale, fiber.radius);
              stiffest = std::max(stiffest, fiber.section.axial);
            }
        }

      const bool rough = std::any_of(
        contributions.begin(),
        contributions.end(),
        [](const auto &contribution) { return contribution->is_rough(); });
      set_caution(contributions, rough ? 1. : 0.);
      NewtonResult      result;
      System::Increment increment;
      unsigned int      adapted_at = 0;
      double            taken      = 1.;

      for (unsigned int iteration = 0;; ++iteration)
        {
          if (stop.received())
            throw Stopped("stopped by " + stop.reason());
          prepare(state, contributions);
          assemble(state, contributions);
          const Residual residual = judge(state, contributions);
          result.residual_ratio   = residual.ratio;
          result.iterations       = iteration;
          report(iteration, residual, result, contributions);

          // Equilibrium counts only if no term objects to it.
          const bool balanced =
            (residual.ratio <= parameters.residual_tolerance ||
             residual.largest_force <= round_off * stiffest) &&
            residual.pending <= reached;
          const bool still =
            iteration > 0 && result.increment <= parameters.increment_tolerance;
          result.obstacle.clear();
          if (balanced && (still || residual.largest_force == 0.))
            {
              for (const auto &contribution : contributions)
                if (result.obstacle.empty())
                  result.obstacle = contribution->objection(state);
              if (result.obstacle.empty())
                {
                  for (const auto &contribution : contributions)
                    contribution->observe(*block_system);
                  result.converged = true;
                  return result;
                }
            }
          else
            result.obstacle =
              balanced ? "the fibers still move" : "forces are not in balance";
          if (iteration == parameters.max_iterations)
            return result;

          const bool calm = rough && result.increment < 0.2 &&
                            residual.ratio < 1. && iteration >= adapted_at + 4;
          if (calm || (balanced && still))
            {
              bool changed = false;
              for (const auto &contribution : contributions)
                changed = contribution->adapt(state) || changed;
              if (changed)
                {
                  adapted_at = iteration;
                  prepare(state, contributions);
                  assemble(state, contributions);
                }
            }

          {
            SectionTimer::Scope scope(timer, "linear solver");
            if (damping > 0.)
              for_each_damped_block(
                state, [this](const unsigned int block, const double value) {
                  block_system->add_diagonal(block, value);
                });
            block_system->end();
            const LinearResult linear = linear_solver->solve();
            result.linear_iterations += linear.iterations;
            result.factorizations += linear_solver->is_direct() ? 1 : 0;
            block_system->extract_increment(increment);
          }

          const double motion = largest_motion(state, increment);
          if (!std::isfinite(motion))
            {
              result.obstacle = "the linear system is singular: a fiber may be "
                                "free to move without resistance";
              return result;
            }
          double largest = 1.;
          for (const auto &contribution : contributions)
            largest =
              std::min(largest, contribution->largest_step(state, increment));
          largest = Utilities::MPI::min(largest, communicator);
          // Prescribed motion does work: it may well raise the energy.
          taken = rough && residual.pending <= reached
                    ? line_search(state, contributions, increment, largest)
                    : largest;
          for (Tensor<1, 3> &motion_of_block : increment)
            motion_of_block *= taken;
          for (const auto &contribution : contributions)
            contribution->predict(state, increment);
          state.move(1., increment);
          result.increment = taken * motion;

          // Soft modes are held back the less the closer equilibrium is.
          if (rough)
            set_caution(contributions, fading(residual.ratio));
        }
    }



    void
    Newton::set_caution(const Contributions &contributions,
                        const double         caution)
    {
      damping = caution * parameters.damping;
      for (const auto &contribution : contributions)
        contribution->set_caution(caution);
    }



    double
    Newton::residual_ratio(System::State       &state,
                           const Contributions &contributions)
    {
      prepare(state, contributions);
      assemble(state, contributions);
      return judge(state, contributions).ratio;
    }



    void
    Newton::prepare(System::State &state, const Contributions &contributions)
    {
      SectionTimer::Scope scope(timer, "detection");
      for (const auto &contribution : contributions)
        contribution->update(state);
      constraints.clear();
      for (const auto &contribution : contributions)
        contribution->constrain(state, constraints);

      bool stale =
        !block_system->tangent() || ghost_version != state.ghost_version();
      for (const auto &contribution : contributions)
        stale = contribution->needs_new_pattern() || stale;
      if (Utilities::MPI::max(stale ? 1 : 0, communicator) > 0)
        {
          System::BlockSystem::Pattern pattern(state.n_owned_blocks());
          for (const auto &contribution : contributions)
            contribution->add_pattern(state, pattern);
          block_system->set_pattern(pattern);
          ghost_version = state.ghost_version();
        }
      block_system->set_constraints(constraints);
    }



    void
    Newton::assemble(System::State &state, const Contributions &contributions)
    {
      SectionTimer::Scope scope(timer, "assembly");
      block_system->begin(System::BlockSystem::Want::residual_and_tangent);
      for (const auto &contribution : contributions)
        contribution->assemble(state, *block_system);
    }



    template <typename Action>
    void
    Newton::for_each_damped_block(const System::State &state,
                                  const Action        &action) const
    {
      const System::FiberSpace &space = state.space;
      const auto                owned = space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          const System::Fiber &fiber     = space.fiber(f);
          const double         stiffness = damping * fiber.section.axial /
                                   (fiber.radius * fiber.radius) *
                                   fiber.length / fiber.n_nodes;
          for (unsigned int i = 0; i < fiber.n_nodes; ++i)
            action(state.local_block(f) + i * space.n_blocks_per_node(),
                   stiffness);
        }
    }



    double
    Newton::damping_curvature(const System::State     &state,
                              const System::Increment &increment) const
    {
      double sum = 0.;
      for_each_damped_block(
        state, [&](const unsigned int block, const double stiffness) {
          sum += stiffness * increment[block].norm_square();
        });
      return Utilities::MPI::sum(sum, communicator);
    }



    Newton::Residual
    Newton::judge(const System::State &state,
                  const Contributions &contributions)
    {
      const System::FiberSpace &space = state.space;
      std::vector<Tensor<1, 3>> unbalanced;
      block_system->unbalanced(unbalanced);

      // A block that is no position answers with a moment: per element length
      // that is a force.
      std::array<double, 3> largest = {};
      const auto            owned   = space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          const double length =
            space.fiber(f).length / (space.fiber(f).n_nodes - 1);
          for (unsigned int b = 0; b < space.n_blocks(f); ++b)
            {
              const unsigned int k = state.local_block(f) + b;
              const double       scale =
                b % space.n_blocks_per_node() == 0 ? 1. : 1. / length;
              largest[0] = std::max(largest[0], scale * unbalanced[k].norm());
              largest[1] = std::max(largest[1],
                                    scale * block_system->residual()[k].norm());
            }
        }
      for (const auto &constraint : constraints)
        for (unsigned int d = 0; d < 3; ++d)
          if (constraint.fixed[d])
            largest[2] = std::max(largest[2], std::abs(constraint.pending[d]));
      max_over_ranks(largest, communicator);

      double typical = 0.;
      for (const auto &contribution : contributions)
        typical = std::max(typical, contribution->typical_force());
      if (typical == 0.)
        typical = largest[1];

      Residual residual;
      residual.largest_force = largest[0];
      residual.ratio         = typical > 0. ? largest[0] / typical : 0.;
      residual.pending       = largest[2] / length_scale;
      return residual;
    }



    double
    Newton::largest_motion(const System::State     &state,
                           const System::Increment &increment) const
    {
      double     largest = 0.;
      const auto owned   = state.space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        for (unsigned int i = 0; i < state.space.fiber(f).n_nodes; ++i)
          {
            const double motion = increment[state.local_block(f) +
                                            i * state.space.n_blocks_per_node()]
                                    .norm();
            // A motion that is not a number is larger than all numbers.
            if (!(motion <= largest))
              largest = std::isnan(motion)
                          ? std::numeric_limits<double>::infinity()
                          : motion;
          }
      return Utilities::MPI::max(largest, communicator) / length_scale;
    }



    double
    Newton::line_search(System::State           &state,
                        const Contributions     &contributions,
                        const System::Increment &increment,
                        const double             largest)
    {
      SectionTimer::Scope scope(timer, "line search");

      // The derivative of the energy along the step: smooth terms by their
      // quadratic model, rough ones as they are.
      std::vector<Tensor<1, 3>> unbalanced;
      block_system->unbalanced(unbalanced);
      const auto rough_part = [&]() {
        std::array<double, 2> sum = {};
        for (const auto &contribution : contributions)
          if (contribution->is_rough())
            {
              const auto part =
                contribution->slope_and_curvature(state, increment);
              sum[0] += part.first;
              sum[1] += part.second;
            }
        sum_over_ranks(sum, communicator);
        return sum;
      };
      double slope = 0.;
      for (unsigned int b = 0; b < unbalanced.size(); ++b)
        slope += unbalanced[b] * increment[b];
      slope = Utilities::MPI::sum(slope, communicator);

      Vec image;
      VecDuplicate(block_system->solution(), &image);
      MatMult(block_system->tangent(), block_system->solution(), image);
      double curvature;
      VecDot(block_system->solution(), image, &curvature);
      VecDestroy(&image);
      curvature -= damping_curvature(state, increment);

      const std::array<double, 2> rough_at_start = rough_part();
      const double                smooth_slope   = slope - rough_at_start[0];
      const double smooth_curvature            = curvature - rough_at_start[1];
      const std::vector<Tensor<1, 3>> start    = state.current();
      const auto                      slope_at = [&](const double factor) {
        state.move(factor, increment);
        for (const auto &contribution : contributions)
          if (contribution->is_rough())
            contribution->probe(state);
        state.set(start);
        return smooth_slope + factor * smooth_curvature + rough_part()[0];
      };

      // Where the slope is still negative the energy still falls; a small
      // positive one is as good. Else go to the root of the slope.
      double low = 0., slope_low = slope, high = largest;
      double slope_high = slope_at(high);
      for (unsigned int trial = 0;
           trial < 6 && slope_high > flat * std::abs(slope);
           ++trial)
        {
          const double guess =
            low + (high - low) * slope_low / (slope_low - slope_high);
          const double next =
            std::min(std::max(guess, low + 0.1 * (high - low)),
                     low + 0.7 * (high - low));
          const double slope_next = slope_at(next);
          if (slope_next < -flat * std::abs(slope))
            {
              low       = next;
              slope_low = slope_next;
              if (trial == 5)
                return low;
            }
          else
            {
              high       = next;
              slope_high = slope_next;
            }
        }
      return high;
    }



    void
    Newton::report(const unsigned int   iteration,
                   const Residual      &residual,
                   const NewtonResult  &result,
                   const Contributions &contributions) const
    {
      log << "  newton " << std::setw(3) << iteration << std::scientific
          << std::setprecision(1) << "  residual " << residual.ratio;
      if (iteration > 0)
        log << "  increment " << result.increment;
      for (const auto &contribution : contributions)
        if (!contribution->status().empty())
          log << "  " << contribution->status();
      log << std::endl;
    }
  } // namespace Solver
} // namespace Heddle
