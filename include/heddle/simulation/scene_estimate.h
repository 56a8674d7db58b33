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

      /** From few to many. */
      using Range = std::pair<double, double>;

      /** The time of a Newton iteration under load [s]. */
      double seconds;

      /** Of one while a fabric settles, without a matrix [s]. */
      double seconds_to_settle;

      /** Of an initial configuration; none if it is not to be computed. */
      Range iterations_to_settle;

      /** Of all load cases, if none has to be cut. */
      Range load_steps;

      /** Of one of them, in the mean. */
      Range iterations_of_step;

      /** Whether an initial configuration is yet to be computed. */
      bool
      settles() const
      {
        return iterations_to_settle.second > 0.;
      }

      /** The time of all of it [s]. */
      Range
      total() const;
    };
  } // namespace Simulation
} // namespace Heddle

#endif
