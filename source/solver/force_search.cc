#include <heddle/solver/force_search.h>

#include <algorithm>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /**
       * So much of what a step promises it has to keep: its linear model takes
       * the part s of it to (1 - s)^2 of the energy of unbalanced forces.
       */
      constexpr double kept_promise = 0.05;

      /** Parts of a step that are tried. */
      constexpr unsigned int n_parts = 7;
    } // namespace



    double
    step_to_balance(System::State           &state,
                    const Contributions     &contributions,
                    System::BlockSystem     &system,
                    const LinearSolver      &solver,
                    const System::Increment &increment,
                    const double             longest)
    {
      const std::vector<Tensor<1, 3>> start  = state.current();
      const double                    before = solver.energy_of_residual();
      const auto                      after  = [&](const double part) {
        System::Increment motion = increment;
        for (Tensor<1, 3> &motion_of_block : motion)
          motion_of_block *= part;
        state.move(1., motion);
        for (auto *term : nonsmooth_terms(contributions))
          term->update_trial(state);
        system.begin(System::BlockSystem::Want::residual);
        for (const auto &contribution : contributions)
          contribution->assemble(state, system);
        state.set(start);
        return solver.energy_of_residual();
      };

      // Negative ones are of a factorization that is not positive definite, and
      // measure nothing.
      double part = std::min(1., longest);
      for (unsigned int trial = 0; trial < n_parts; ++trial, part /= 2.)
        {
          const double energy = after(part);
          if (energy >= 0. && energy < (1. - 2. * kept_promise * part) * before)
            return part;
        }
      after(0.);
      return 0.;
    }
  } // namespace Solver
} // namespace Heddle
