#include <heddle/contributions/nodal_springs.h>

#include <algorithm>

namespace Heddle
{
  namespace Contributions
  {
    NodalSprings::NodalSprings(const std::string         &name,
                               const std::vector<Spring> &springs)
      : own_name(name)
      , springs(springs)
    {
      for (const Spring &spring : springs)
        largest_force = std::max(largest_force, spring.force.norm());
    }



    void
    NodalSprings::assemble(const System::State &state,
                           System::BlockSystem &system)
    {
      for (const Spring &spring : springs)
        if (state.space.owns(spring.fiber))
          {
            const unsigned int block =
              state.local_block(spring.fiber) +
              spring.node * state.space.n_blocks_per_node();
            const Tensor<1, 3> residual =
              spring.stiffness * (state.current()[block] - spring.target) -
              spring.force;
            system.add(
              1, &block, residual.begin_raw(), spring.stiffness[0].begin_raw());
          }
    }
  } // namespace Contributions
} // namespace Heddle
