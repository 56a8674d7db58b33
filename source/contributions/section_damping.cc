#include <heddle/contributions/section_damping.h>

#include <algorithm>

namespace Heddle
{
  namespace Contributions
  {
    namespace
    {
      /** Small beside the stiffness of the section, E A per length. */
      constexpr double relative_stiffness = 3e-4;

      /**
       * Turns in an iteration below which sections are let go [rad]. Sooner
       * than this, frictionless fibers spin away: the paper's plain weave then
       * finds no equilibrium in 150 iterations. With friction moments act, and
       * where fibers are to turn by much it takes hundreds of iterations at
       * this pace (doc/benchmarks.md).
       */
      constexpr double still_without_friction = 0.005,
                       still_with_friction    = 0.1;

      /** Largest factor by which the stiffness falls in an iteration. */
      constexpr double largest_fall = 3.;

      /** Enough for a tangent that is not singular. */
      constexpr double least_part = 1e-3;
    } // namespace



    SectionDamping::SectionDamping(const bool with_friction)
      : still(with_friction ? still_with_friction : still_without_friction)
    {
    }



    void
    SectionDamping::begin_step(System::State &state)
    {
      const auto owned = state.space.owned_fibers();
      parts.assign(owned.second - owned.first, 1.);
    }



    void
    SectionDamping::predict(const System::State     &state,
                            const System::Increment &increment)
    {
      const System::FiberSpace &space    = state.space;
      const unsigned int        per_node = space.n_blocks_per_node();
      const auto                owned    = space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          double turn = 0.;
          for (unsigned int b = 0; b < space.n_blocks(f); ++b)
            if (b % per_node > 0)
              turn = std::max(turn, increment[state.local_block(f) + b].norm());
          double &part = parts[f - owned.first];
          part         = std::clamp(
            part * std::max(turn / still, 1. / largest_fall), least_part, 1.);
        }
    }



    void
    SectionDamping::assemble(const System::State &state,
                             System::BlockSystem &system)
    {
      const System::FiberSpace &space    = state.space;
      const unsigned int        per_node = space.n_blocks_per_node();
      // With two blocks the second one is the tangent of a Hermite curve.
      if (per_node < 3 || !system.wants_tangent())
        return;

      const auto owned = space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          const System::Fiber &fiber = space.fiber(f);
          const double stiffness = parts[f - owned.first] * relative_stiffness *
                                   fiber.section.axial * fiber.length /
                                   fiber.n_nodes;
          for (unsigned int b = 0; b < space.n_blocks(f); ++b)
            if (b % per_node > 0)
              system.add_diagonal(state.local_block(f) + b, stiffness);
        }
    }
  } // namespace Contributions
} // namespace Heddle
