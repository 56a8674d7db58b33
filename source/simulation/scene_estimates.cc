// How much memory and time a scene takes, before it is computed.
#include <heddle/simulation/scene.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace Heddle
{
  namespace Simulation
  {
    MatrixEstimate
    Scene::estimated_matrix() const
    {
      return parameters.matrix.enabled
               ? MatrixEstimate(parameters.matrix, paths)
               : MatrixEstimate();
    }



    bool
    Scene::will_be_factorized(const double n_matrix_nodes) const
    {
      return parameters.linear_solver.direct(fiber_space->n_dofs() +
                                               std::lround(3. * n_matrix_nodes),
                                             fiber_contact != nullptr,
                                             parameters.matrix.enabled);
    }



    double
    Scene::estimated_memory(const double n_matrix_nodes) const
    {
      // What every rank takes before there is a scene: libraries, buffers.
      const double idle =
        165e6 * Utilities::MPI::n_mpi_processes(fiber_space->communicator());

      // Measured with 30 000 to 270 000 unknowns, and met to a fifth with
      // conjugate gradients, see doc/benchmarks.md: elements, matrix, factors
      // and vectors by unknowns; cells and what couples fibers by watched
      // cells, of which there are about 16 for a node of a packed yarn. A
      // sparse factorization takes far more.
      const double n_dofs = fiber_space->n_dofs();
      const double fibers =
        will_be_factorized(n_matrix_nodes)
          ? (fiber_friction ? 14e3 : 7e3) * n_dofs
          : 0.88e3 * n_dofs +
              (fiber_contact ? 16. * fiber_space->n_nodes() : 0.) *
                (fiber_friction ? 1.16e3 : 0.47e3);

      // Nodes of the matrix are coupled to those of the cells around them:
      // blocks of 3 x 3.
      const double per_node = parameters.matrix.degree == 1 ? 27. : 64.;
      const double times    = will_be_factorized(n_matrix_nodes) ? 10. : 2.;
      return idle + fibers +
             times * n_matrix_nodes * per_node * 9. * sizeof(double);
    }



    double
    Scene::estimated_seconds(const double n_matrix_nodes) const
    {
      // Measured with 6 000 to 380 000 unknowns on one rank, and met to a
      // quarter.
      const double n_dofs = fiber_space->n_dofs() + 3. * n_matrix_nodes;
      return (will_be_factorized(n_matrix_nodes) ? 16e-6 : 4e-6) * n_dofs /
             Utilities::MPI::n_mpi_processes(fiber_space->communicator());
    }
  } // namespace Simulation
} // namespace Heddle
