#ifndef heddle_simulation_own_contributions_h
#define heddle_simulation_own_contributions_h

#include <heddle/solver/terms.h>
#include <heddle/system/fiber_space.h>

#include <functional>
#include <vector>

namespace Heddle
{
  namespace Simulation
  {
    using namespace dealii;

    /**
     * Makes contributions that heddle does not have, for a stage with loads:
     * they act there beside those of the parameter file. Given are the fibers
     * and the owned blocks of the configuration in which they are placed. Those
     * of a fabric settle before the stage begins: what counts from there has to
     * be taken in Contribution::begin_stage(), and saved.
     */
    using OwnContributions = std::function<Solver::Contributions(
      const System::FiberSpace        &space,
      const std::vector<Tensor<1, 3>> &initial)>;
  } // namespace Simulation
} // namespace Heddle

#endif
