#ifndef heddle_simulation_yarn_guides_h
#define heddle_simulation_yarn_guides_h

#include <heddle/contributions/nodal_springs.h>
#include <heddle/simulation/settle_parameters.h>
#include <heddle/system/fiber_space.h>
#include <heddle/textile/fiber_path.h>

#include <memory>
#include <vector>

namespace Heddle
{
  namespace Simulation
  {
    /**
     * What holds the yarns of a weave: every end of a fiber is guided across
     * its yarn, drawn along it and free to slide; the middle of the fiber is
     * held along it, so that the fiber cannot drift away.
     */
    std::shared_ptr<Contributions::NodalSprings>
    yarn_guides(const System::FiberSpace              &space,
                const std::vector<Textile::FiberPath> &paths,
                const SettleParameters                &parameters);
  } // namespace Simulation
} // namespace Heddle

#endif
