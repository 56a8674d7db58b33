#include <heddle/solver/fiber_damping.h>

#include <algorithm>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /** What a fiber moves in an iteration if all goes well, in radii. */
      constexpr double wanted_motion = 0.3;

      /** Largest change of the damping in one iteration. */
      constexpr double largest_factor = 3.;

      /** Damping grows by this factor where a step had to be cut to half. */
      constexpr double growth_after_cut = 2.;

      /** In between a fiber moves as if it was alone, or not at all. */
      constexpr double least = 1e-6, largest = 1e-2;



      /** The least damping, from which it may rise again, counts as none. */
      double
      used(const double value)
      {
        return value > least ? value : 0.;
      }
    } // namespace



    FiberDamping::FiberDamping(const System::FiberSpace &space,
                               const double              first)
      : space(space)
      , first(first)
    {
      reset(/*in_motion=*/false);
    }



    void
    FiberDamping::reset(const bool in_motion)
    {
      const auto owned = space.owned_fibers();
      values.assign(owned.second - owned.first,
                    first == 0. ? 0.
                    : in_motion ? std::max(first, least)
                                : least);
    }



    template <typename Action>
    void
    FiberDamping::for_each_node(const System::State &state,
                                const Action        &action) const
    {
      const auto owned = space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          const System::Fiber &fiber = space.fiber(f);
          const double         stiffness =
            used(values[f - owned.first]) * fiber.section.axial /
            (fiber.radius * fiber.radius) * fiber.length / fiber.n_nodes;
          for (unsigned int i = 0; i < fiber.n_nodes; ++i)
            action(state.local_block(f) + i * space.n_blocks_per_node(),
                   stiffness);
        }
    }



    void
    FiberDamping::add_to(System::BlockSystem &system,
                         const System::State &state) const
    {
      for_each_node(
        state, [&system](const unsigned int block, const double stiffness) {
          system.add_diagonal(block, stiffness);
        });
    }



    double
    FiberDamping::curvature(const System::State     &state,
                            const System::Increment &increment) const
    {
      double sum = 0.;
      for_each_node(
        state,
        [&sum, &increment](const unsigned int block, const double stiffness) {
          sum += stiffness * increment[block].norm_square();
        });
      return sum;
    }



    void
    FiberDamping::adapt(const System::State     &state,
                        const System::Increment &increment,
                        const double             taken,
                        const double             radius)
    {
      if (first == 0.)
        return;
      const auto owned = space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          double motion = 0.;
          for (unsigned int i = 0; i < space.fiber(f).n_nodes; ++i)
            motion = std::max(
              motion,
              increment[state.local_block(f) + i * space.n_blocks_per_node()]
                .norm());
          const double ratio = motion / (wanted_motion * radius);
          double      &value = values[f - owned.first];
          value *= std::clamp(ratio, 1. / largest_factor, largest_factor);
          if (taken < 0.5 && ratio > 0.3)
            value *= growth_after_cut;
          value = std::clamp(value, least, largest);
        }
    }
  } // namespace Solver
} // namespace Heddle
