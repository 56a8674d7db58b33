// What goes before an iteration: the linear system and all terms made ready,
// and a guess of the step followed.
#include <heddle/base/exceptions.h>
#include <heddle/solver/newton.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /** A guess that misses more than this of what is prescribed is none. */
      constexpr double largest_miss = 0.5;

      /** A guess of which no more than this may be gone along at a time leads
       * where nothing can go. */
      constexpr double least_part_of_guess = 1e-3;

      /** Parts of a step below this are round-off. */
      constexpr double round_off = 1e-13;

      /**
       * So much of the size of a scene are positions off in a solved system,
       * for they have no more digits: the last one, and some more by the
       * solver. On a cantilever of 256 elements it was up to 50 in Debug.
       */
      constexpr double last_digits =
        256. * std::numeric_limits<double>::epsilon();
    } // namespace



    void
    Newton::begin(const System::State &state)
    {
      if (block_system && field_version == state.field_version())
        return;
      linear_solver.reset();
      field_version = state.field_version();

      // What is factorized has to be in the matrix. Where nothing is in contact
      // a system may be factorized nevertheless: nothing couples fibers then.
      block_system = std::make_unique<System::BlockSystem>(
        state,
        /*couplings_apart=*/
        !linear_parameters.direct(state.n_dofs(),
                                  /*contact=*/true,
                                  /*matrix=*/state.matrix() != nullptr));
      linear_solver =
        std::make_unique<LinearSolver>(linear_parameters, *block_system);
      secants = std::make_unique<Secants>();
      damping = std::make_unique<FiberDamping>(state.space, parameters.damping);
      length_scale = state.space.fiber(0).radius;
      for (unsigned int f = 0; f < state.space.n_fibers(); ++f)
        length_scale = std::min(length_scale, state.space.fiber(f).radius);
    }



    void
    Newton::find_negligible_forces(const System::State &state,
                                   const Contributions &contributions)
    {
      negligible.of_fibers.assign(state.space.n_fibers(), 0.);
      negligible.of_matrix = 0.;
      for (const auto &contribution : contributions)
        contribution->raise_stiffness(negligible);
      double size = 0.;
      for (unsigned int b = 0; b < state.n_owned_fiber_blocks();
           b += state.space.n_blocks_per_node())
        size = std::max(size, state.current()[b].norm());
      for (unsigned int b = state.n_owned_fiber_blocks();
           b < state.n_owned_blocks();
           ++b)
        size = std::max(size, state.current()[b].norm());
      const double last_digit =
        last_digits * Utilities::MPI::max(size, communicator);
      for (double &force : negligible.of_fibers)
        force *= last_digit;
      negligible.of_matrix *= last_digit;
    }



    void
    Newton::collect_constraints(const System::State &state,
                                const Contributions &contributions)
    {
      constraints.clear();
      for (const auto &contribution : contributions)
        contribution->constrain(state, constraints);
    }



    void
    Newton::update(System::State &state, const Contributions &contributions)
    {
      for (const auto &contribution : contributions)
        contribution->update(state);
      collect_constraints(state, contributions);
    }



    void
    Newton::prepare(System::State &state, const Contributions &contributions)
    {
      SectionTimer::Scope scope(timer, "detection");
      update(state, contributions);
      for (const auto &contribution : contributions)
        contribution->begin_iteration(state);

      bool stale =
        !block_system->tangent() || ghost_version != state.ghost_version();
      for (const auto &contribution : contributions)
        stale = contribution->needs_new_pattern() || stale;
      if (Utilities::MPI::max(stale ? 1 : 0, communicator) > 0)
        {
          System::BlockPattern pattern(state.n_owned_blocks(),
                                       block_system->keeps_couplings_apart());
          for (const auto &contribution : contributions)
            contribution->add_pattern(state, pattern);
          block_system->set_pattern(pattern);
          ghost_version = state.ghost_version();
        }
      block_system->set_constraints(constraints);
    }



    void
    Newton::assemble(System::State                  &state,
                     const Contributions            &contributions,
                     const System::BlockSystem::Want want)
    {
      SectionTimer::Scope scope(timer, "assembly");
      block_system->begin(want);
      for (const auto &contribution : contributions)
        contribution->assemble(state, *block_system);
    }



    Residual
    Newton::judge(const Contributions &contributions) const
    {
      return Solver::judge(
        *block_system, contributions, constraints, negligible);
    }



    double
    Newton::residual_ratio(System::State       &state,
                           const Contributions &contributions)
    {
      // No system is solved here: its pattern and tangent can wait.
      begin(state);
      find_negligible_forces(state, contributions);
      {
        SectionTimer::Scope scope(timer, "detection");
        update(state, contributions);
        block_system->set_constraints(constraints);
      }
      assemble(state, contributions, System::BlockSystem::Want::residual);
      return judge(contributions).ratio;
    }



    bool
    Newton::follow(System::State           &state,
                   const Contributions     &contributions,
                   const System::Increment &guess)
    {
      // A rank without fibers has no part in a guess, but goes along. Without
      // rough terms Newton's method goes further in one step.
      if (Utilities::MPI::max(guess.empty() ? 0 : 1, communicator) == 0 ||
          std::none_of(contributions.begin(),
                       contributions.end(),
                       [](const auto &one) { return one->is_rough(); }))
        return false;
      SectionTimer::Scope scope(timer, "detection");

      // What does not bring the ends where they are to go leads elsewhere.
      const auto motion = [&] {
        System::Increment whole = guess;
        whole.resize(state.n_local_blocks());
        state.update_ghosts(whole);
        return whole;
      };
      collect_constraints(state, contributions);
      const double      before = pending_motion(constraints, communicator);
      System::Increment whole  = motion();
      state.move(1., whole);
      collect_constraints(state, contributions);
      const double after = pending_motion(constraints, communicator);
      state.move(-1., whole);
      if (after > largest_miss * before + reached * length_scale)
        return false;

      double left = 1., part = 0.;
      while (true)
        {
          if (stop.received())
            throw Stopped("stopped by " + stop.reason());
          for (const auto &contribution : contributions)
            contribution->update(state);
          whole = motion();
          if (!std::all_of(contributions.begin(),
                           contributions.end(),
                           [](const auto &one) { return one->is_credible(); }))
            {
              state.move(-part, whole);
              return left + part < 1.;
            }
          if (left == 0.)
            return true;
          part = left;
          for (const auto &contribution : contributions)
            part = std::min({part,
                             contribution->largest_step(state, whole),
                             contribution->searched_step(state, whole)});
          part = Utilities::MPI::min(part, communicator);
          // The closer to a cell that is inside out, the shorter.
          if (part < std::min(left, least_part_of_guess))
            {
              state.move(left - 1., whole);
              return false;
            }
          state.move(part, whole);
          left = left - part > round_off ? left - part : 0.;
        }
    }
  } // namespace Solver
} // namespace Heddle
