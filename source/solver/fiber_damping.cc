#include <heddle/solver/fiber_damping.h>

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
      /** What a fiber moves in an iteration if all goes well, in radii. */
      constexpr double wanted_motion = 0.6;

      /** What counts as a radius there of a fiber that touches nothing, over
       * its length. */
      constexpr double part_of_length = 0.02;

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

      /** Of the stiffness of a node, what is round-off [-]. */
      constexpr double digits_of_node =
        256. * std::numeric_limits<double>::epsilon();
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
      alone            = false;
      const auto owned = space.owned_fibers();
      values.assign(owned.second - owned.first,
                    first == 0. ? 0.
                    : in_motion ? std::max(first, least)
                                : least);
    }



    void
    FiberDamping::reset_alone()
    {
      reset(/*in_motion=*/true);
      alone = true;
    }



    void
    FiberDamping::end_alone()
    {
      if (!alone)
        return;
      alone = false;
      if (first > 0.)
        for (double &value : values)
          value = std::max(value, least);
    }



    double
    FiberDamping::least_of(const unsigned int f) const
    {
      const double slenderness = space.fiber(f).length / space.fiber(f).radius;
      return alone ? std::min(least, std::pow(slenderness, -4)) : least;
    }



    double
    FiberDamping::used(const unsigned int k) const
    {
      const unsigned int f = space.owned_fibers().first + k;
      return values[k] > least_of(f) ? values[k] : 0.;
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
                                 const double         of_sections,
                                 const Action        &action) const
    {
      // Three blocks per node: a position and two section vectors. Two: a
      // position and a tangent.
      const unsigned int n_per_node = space.n_blocks_per_node();
      const unsigned int n_free     = n_per_node == 3 ? 3 : 1;
      for (unsigned int i = 0; i < space.fiber(f).n_nodes; ++i)
        for (unsigned int k = 0; k < n_free; ++k)
          action(state.local_block(f) + i * n_per_node + k,
                 k == 0 ? 1. : of_sections);
    }



    template <typename Action>
    void
    FiberDamping::for_each_stiffness(const System::State &state,
                                     const Action        &action) const
    {
      const auto owned = space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          const System::Fiber &fiber = space.fiber(f);
          const double stiffness = used(f - owned.first) * fiber.section.axial /
                                   (fiber.radius * fiber.radius) *
                                   fiber.length / fiber.n_nodes;
          // Section vectors move the surface by the radius times their own
          // motion.
          for_each_block(state,
                         f,
                         fiber.radius,
                         [&](const unsigned int block, const double lever) {
                           action(block, stiffness * lever * lever);
                         });
        }
    }



    void
    FiberDamping::add_to(System::BlockSystem &system,
                         const System::State &state) const
    {
      for_each_stiffness(
        state, [&system](const unsigned int block, const double stiffness) {
          system.add_diagonal(block, stiffness);
        });
    }



    void
    FiberDamping::add_uncertainty_to(System::BlockSystem &system,
                                     const System::State &state,
                                     const double         unbalanced) const
    {
      const auto owned = space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          const System::Fiber &fiber    = space.fiber(f);
          const double         distance = fiber.length / fiber.n_nodes;
          const double         stiffness =
            digits_of_node * fiber.section.axial / distance +
            unbalanced / fiber.length;
          for_each_block(state,
                         f,
                         distance,
                         [&](const unsigned int block, const double lever) {
                           system.add_diagonal(block,
                                               stiffness * lever * lever);
                         });
        }
    }



    double
    FiberDamping::curvature(const System::State     &state,
                            const System::Increment &increment) const
    {
      double sum = 0.;
      for_each_stiffness(
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
          for_each_block(state,
                         f,
                         space.fiber(f).radius,
                         [&](const unsigned int block, const double lever) {
                           motion =
                             std::max(motion, lever * increment[block].norm());
                         });
          const double scale =
            alone ? std::max(radius, part_of_length * space.fiber(f).length)
                  : radius;
          const double ratio = motion / (wanted_motion * scale);
          double      &value = values[f - owned.first];
          value *= std::clamp(ratio, 1. / largest_factor, largest_factor);
          if (taken < much_cut && ratio > much_moved)
            value *= growth_after_cut;
          value = std::clamp(value, least_of(f), largest);
        }
    }
  } // namespace Solver
} // namespace Heddle
