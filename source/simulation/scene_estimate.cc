#include <heddle/simulation/scene_estimate.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace Heddle
{
  namespace Simulation
  {
    namespace
    {
      /** Of a scene with a matrix of so many nodes [bytes]. */
      double
      estimated_memory(const Scene &scene,
                       const bool   is_factorized,
                       const double n_matrix_nodes,
                       const double matrix_degree)
      {
        const System::FiberSpace &space        = scene.space();
        const bool                has_friction = scene.friction() != nullptr;

        // What every rank takes before there is a scene: libraries, buffers.
        const double idle =
          165e6 * Utilities::MPI::n_mpi_processes(space.communicator());

        // Measured with 30 000 to 270 000 unknowns, and met to a fifth with
        // conjugate gradients, see doc/benchmarks.md: elements, matrix, factors
        // and vectors by unknowns; cells and what couples fibers by watched
        // cells, of which there are about 16 for a node of a packed yarn. A
        // sparse factorization takes far more.
        const double n_dofs = space.n_dofs();
        const double fibers =
          is_factorized
            ? (has_friction ? 14e3 : 7e3) * n_dofs
            : 0.88e3 * n_dofs + (scene.contact() ? 16. * space.n_nodes() : 0.) *
                                  (has_friction ? 1.16e3 : 0.47e3);

        // Nodes of the matrix are coupled to those of the cells around them,
        // by blocks of 3 x 3; as much again and more goes into its mesh and
        // cells. Met to a sixth with 18 000 and 57 000 nodes of both degrees.
        const double per_node = matrix_degree == 1 ? 27. : 64.;
        const double times    = is_factorized ? 10. : 3.4;
        return idle + fibers +
               times * n_matrix_nodes * per_node * 9. * sizeof(double);
      }



      /** Measured with 6 000 to 380 000 unknowns on one rank, and met to a
       * quarter. */
      double
      seconds_of_iteration(const Scene &scene,
                           const bool   is_factorized,
                           const double n_dofs)
      {
        return (is_factorized ? 16e-6 : 4e-6) * n_dofs /
               Utilities::MPI::n_mpi_processes(scene.space().communicator());
      }



      /** As benchmarks.md has them ("Size", "The paper's fabrics"): friction
       * holds fibers that would go on from neighbour to neighbour. */
      std::pair<unsigned int, unsigned int>
      iterations_of_settling(const Scene &scene, const Parameters &parameters)
      {
        constexpr unsigned int                many_fibers = 500;
        std::pair<unsigned int, unsigned int> result(40, 300);
        if (scene.friction() && parameters.settle.friction)
          result = scene.space().n_fibers() > many_fibers
                     ? std::make_pair(80u, 300u)
                     : std::make_pair(30u, 200u);
        if (scene.weave() && parameters.weave.description().start ==
                               Textile::Start::interpenetrating)
          {
            const unsigned int ordering =
              parameters.ordering.n_steps * parameters.ordering.iterations;
            result.first += ordering;
            result.second += ordering;
          }
        return result;
      }
    } // namespace



    SceneEstimate::SceneEstimate(const Scene      &scene,
                                 const Parameters &parameters)
      : matrix(parameters.matrix.enabled
                 ? MatrixEstimate(parameters.matrix, scene.fiber_paths())
                 : MatrixEstimate())
      , is_factorized(parameters.linear_solver.direct(
          scene.space().n_dofs() + std::lround(3. * matrix.n_nodes),
          scene.contact() != nullptr || parameters.plates.are_there(),
          parameters.matrix.enabled))
      , memory(estimated_memory(scene,
                                is_factorized,
                                matrix.n_nodes,
                                parameters.matrix.degree))
    {
      const double n_dofs = scene.space().n_dofs();
      seconds             = seconds_of_iteration(
        scene, is_factorized, n_dofs + 3. * matrix.n_nodes);
      seconds_to_settle = seconds_of_iteration(
        scene,
        parameters.linear_solver.direct(
          scene.space().n_dofs(), /*with_contact=*/true, /*with_matrix=*/false),
        n_dofs);
      iterations_to_settle = iterations_of_settling(scene, parameters);
    }
  } // namespace Simulation
} // namespace Heddle
