#ifndef heddle_simulation_fiber_placement_h
#define heddle_simulation_fiber_placement_h

#include <heddle/simulation/fiber_parameters.h>
#include <heddle/system/state.h>
#include <heddle/textile/fiber_path.h>

#include <memory>
#include <vector>

namespace Heddle
{
  namespace Simulation
  {
    using namespace dealii;

    /** Number the fibers and give them elements of equal lengths. */
    std::unique_ptr<System::FiberSpace>
    make_space(const std::vector<Textile::FiberPath> &paths,
               const FiberParameters                 &parameters,
               const MPI_Comm                         communicator);

    /**
     * Densities of the fibers [g/cm^3], of their yarns or of their materials;
     * 0: not known. Throws InputError if both are given and differ.
     */
    std::vector<double>
    densities_of(const System::FiberSpace              &space,
                 const std::vector<Textile::FiberPath> &paths,
                 const FiberParameters                 &parameters);

    /**
     * Blocks of one fiber whose nodes are @p points: tangents from the parabola
     * through neighbouring points, sections normal to the axis, unstrained, and
     * carried along it without twist.
     */
    void
    place_fiber(const System::FiberSpace        &space,
                const unsigned int               fiber,
                const std::vector<Tensor<1, 3>> &points,
                Tensor<1, 3>                    *blocks);

    /** Owned blocks of the fibers on their paths. */
    std::vector<Tensor<1, 3>>
    place_on_paths(const System::FiberSpace              &space,
                   const std::vector<Textile::FiberPath> &paths);

    /** Owned blocks of straight, unstretched fibers. */
    std::vector<Tensor<1, 3>>
    place_straight(const System::FiberSpace &space);
  } // namespace Simulation
} // namespace Heddle

#endif
