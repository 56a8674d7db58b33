#include <heddle/solver/fiber_spin.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /** Of fibers that hardly move. Section vectors become longer by less than
       * half a thousandth: fibers of fabrics are strained as much as they
       * settle. */
      constexpr double largest_spin = 0.03;

      /** A position and two section vectors. */
      constexpr unsigned int n_blocks_of_director_node = 3;

      /**
       * By how much a section turns about its axis. A turn by s about a x b
       * moves a by s b, and b by -s a, if these are unit vectors across each
       * other: of a motion of both s is the part along that.
       */
      double
      spin(const System::State     &state,
           const System::Increment &increment,
           const unsigned int       node)
      {
        const Tensor<1, 3> &a = state.current()[node + 1],
                           &b = state.current()[node + 2];
        return (b * increment[node + 1] - a * increment[node + 2]) /
               (a.norm_square() + b.norm_square());
      }



      /** Call @p action for the first block of each node of fiber @p f. */
      template <typename Action>
      void
      for_each_node(const System::State &state,
                    const unsigned int   f,
                    const Action        &action)
      {
        const unsigned int begin = state.local_block(f);
        for (unsigned int b = 0; b < state.space.n_blocks(f);
             b += n_blocks_of_director_node)
          action(begin + b);
      }



      bool
      has_sections(const System::FiberSpace &space)
      {
        return space.n_blocks_per_node() == n_blocks_of_director_node;
      }
    } // namespace



    bool
    limit_spin(const System::State &state, System::Increment &increment)
    {
      const System::FiberSpace &space = state.space;
      if (!has_sections(space))
        return false;
      bool       any   = false;
      const auto owned = space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          double most = 0., allowed = largest_spin;
          for_each_node(state, f, [&](const unsigned int node) {
            most = std::max(most, std::abs(spin(state, increment, node)));
            allowed =
              std::max(allowed, increment[node].norm() / space.fiber(f).radius);
          });
          if (most <= allowed)
            continue;
          any = true;
          for_each_node(state, f, [&](const unsigned int node) {
            const double excess =
              (1. - allowed / most) * spin(state, increment, node);
            increment[node + 1] -= excess * state.current()[node + 2];
            increment[node + 2] += excess * state.current()[node + 1];
          });
        }
      return Utilities::MPI::max(any ? 1 : 0, space.communicator()) > 0;
    }
  } // namespace Solver
} // namespace Heddle
