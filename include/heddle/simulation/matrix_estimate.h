#ifndef heddle_simulation_matrix_estimate_h
#define heddle_simulation_matrix_estimate_h

#include <heddle/simulation/matrix_parameters.h>
#include <heddle/textile/fiber_path.h>

#include <array>
#include <string>
#include <vector>

namespace Heddle
{
  namespace Simulation
  {
    /**
     * How large a matrix will be, before there is the configuration in which
     * fibers are embedded: its mesh around the paths from which they start.
     * Yarns that start interpenetrating are less thick there, and what is left
     * out inside of yarns differs.
     */
    struct MatrixEstimate
    {
      /** Of no matrix. */
      MatrixEstimate() = default;

      MatrixEstimate(const MatrixParameters                &parameters,
                     const std::vector<Textile::FiberPath> &paths);

      double                n_cells = 0.;
      double                n_nodes = 0.;
      std::array<double, 3> extent  = {}; /**< along x, y, z [mm] */

      /** What is wrong with a mesh around the paths; empty if nothing is. */
      std::string objection;
    };
  } // namespace Simulation
} // namespace Heddle

#endif
