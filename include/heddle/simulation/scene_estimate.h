#ifndef heddle_simulation_scene_estimate_h
#define heddle_simulation_scene_estimate_h

#include <heddle/simulation/matrix_estimate.h>
#include <heddle/simulation/scene.h>

#include <utility>

namespace Heddle
{
  namespace Simulation
  {
    /** What a scene will take, roughly, before it is computed. */
    struct SceneEstimate
    {
      SceneEstimate(const Scene &scene, const Parameters &parameters);

      /** How large the matrix will be; nothing if there is none. */
      MatrixEstimate matrix;

      /** Whether the tangent will be factorized. */
      bool is_factorized;

      /** What the solver will need over all ranks [bytes]. */
      double memory;

      /** The time of one Newton iteration of fibers in contact [s]. */
      double seconds;

      /** Of one while a fabric settles, without a matrix [s]. */
      double seconds_to_settle;

      /** Of an initial configuration, from few to many, if there is one. */
      std::pair<unsigned int, unsigned int> iterations_to_settle;
    };
  } // namespace Simulation
} // namespace Heddle

#endif
