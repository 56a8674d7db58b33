#include <heddle/contributions/section_damping.h>

namespace Heddle
{
  namespace Contributions
  {
    namespace
    {
      /** Small beside the stiffness of the section, E A per length. */
      constexpr double relative_stiffness = 3e-4;
    } // namespace



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
          const double stiffness = relative_stiffness * fiber.section.axial *
                                   fiber.length / fiber.n_nodes;
          for (unsigned int b = 0; b < space.n_blocks(f); ++b)
            if (b % per_node > 0)
              system.add_diagonal(state.local_block(f) + b, stiffness);
        }
    }
  } // namespace Contributions
} // namespace Heddle
