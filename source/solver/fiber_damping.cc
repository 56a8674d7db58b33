#include <heddle/solver/fiber_damping.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /** What a fiber moves in an iteration if all goes well, in radii. */
      constexpr double wanted_motion = 0.6;

      /** Largest change of the damping in one iteration. */
      constexpr double largest_factor = 3.;

      /** Where a step is cut to less than this part of it, damping ... */
      constexpr double much_cut = 0.5;

      /** ... of fibers that were to move by more than this part of it ... */
      constexpr double much_moved = 0.3;

      /** ... grows by this factor, ... */
      constexpr double growth_after_cut = 2.;

      /** ... and by this one where steps lead uphill. */
      constexpr double growth_uphill = 10.;

      /** With the least a fiber moves as if nothing held it, with the largest
       * hardly at all. */
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



    bool
    FiberDamping::raise()
    {
      bool changed = false;
      if (first > 0.)
        for (double &value : values)
          {
            changed = changed || value < largest;
            value   = std::min(growth_uphill * value, largest);
          }
      return Utilities::MPI::max(changed ? 1 : 0, space.communicator()) > 0;
    }



    template <typename Action>
    void
    FiberDamping::for_each_block(const System::State &state,
                                 const unsigned int   f,
                                 const Action        &action) const
    {
      // Three blocks per node: a position and two section vectors, which move
      // the surface by the radius times their own motion. Two: a position and
      // a tangent.
      const System::Fiber &fiber      = space.fiber(f);
      const unsigned int   n_per_node = space.n_blocks_per_node();
      const unsigned int   n_free     = n_per_node == 3 ? 3 : 1;
      for (unsigned int i = 0; i < fiber.n_nodes; ++i)
        for (unsigned int k = 0; k < n_free; ++k)
          action(state.local_block(f) + i * n_per_node + k,
                 k == 0 ? 1. : fiber.radius);
    }



    template <typename Damping, typename Action>
    void
    FiberDamping::for_each_stiffness(const System::State &state,
                                     const Damping       &damping,
                                     const Action        &action) const
    {
      const auto owned = space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          const System::Fiber &fiber = space.fiber(f);
          const double         stiffness =
            damping(f - owned.first) * fiber.section.axial /
            (fiber.radius * fiber.radius) * fiber.length / fiber.n_nodes;
          for_each_block(
            state, f, [&](const unsigned int block, const double lever) {
              action(block, stiffness * lever * lever);
            });
        }
    }



    void
    FiberDamping::add_to(System::BlockSystem &system,
                         const System::State &state) const
    {
      for_each_stiffness(
        state,
        [this](const unsigned int k) { return used(values[k]); },
        [&system](const unsigned int block, const double stiffness) {
          system.add_diagonal(block, stiffness);
        });
    }



    void
    FiberDamping::add_to(System::BlockSystem &system,
                         const System::State &state,
                         const double         damping) const
    {
      for_each_stiffness(
        state,
        [damping](unsigned int) { return damping; },
        [&system](const unsigned int block, const double stiffness) {
          system.add_diagonal(block, stiffness);
        });
    }



    double
    FiberDamping::curvature(const System::State     &state,
                            const System::Increment &increment) const
    {
      double sum = 0.;
      for_each_stiffness(
        state,
        [this](const unsigned int k) { return used(values[k]); },
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
          for_each_block(
            state, f, [&](const unsigned int block, const double lever) {
              motion = std::max(motion, lever * increment[block].norm());
            });
          const double ratio = motion / (wanted_motion * radius);
          double      &value = values[f - owned.first];
          value *= std::clamp(ratio, 1. / largest_factor, largest_factor);
          if (taken < much_cut && ratio > much_moved)
            value *= growth_after_cut;
          value = std::clamp(value, least, largest);
        }
    }
  } // namespace Solver
} // namespace Heddle
