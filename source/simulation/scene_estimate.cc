#include <heddle/simulation/scene_estimate.h>
#include <heddle/solver/load_stepping.h>

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



      /**
       * By a machine of doc/benchmarks.md that others there are twice as fast
       * as. With conjugate gradients as many seconds for each unknown, in a
       * factorization more, where contacts fill it: 0.1, 0.9 and 22 s with
       * 6 000, 32 000 and 96 000 unknowns.
       */
      double
      seconds_of_iteration(const Scene &scene,
                           const bool   is_factorized,
                           const bool   under_load,
                           const double n_matrix_dofs)
      {
        const double n_dofs = scene.space().n_dofs();
        const double n      = n_dofs + n_matrix_dofs;
        const double fill   = n / 30e3;
        const double of_fibers =
          under_load && scene.friction() != nullptr ? 9e-6 : 6e-6;
        const double work =
          is_factorized ? 16e-6 * n * (scene.contact() ? 1. + fill * fill : 1.)
                        : of_fibers * n_dofs + 15e-6 * n_matrix_dofs;
        return work /
               Utilities::MPI::n_mpi_processes(scene.space().communicator());
      }



      /** As benchmarks.md has them ("Size", "The paper's fabrics"): friction
       * holds fibers that would go on from neighbour to neighbour. */
      SceneEstimate::Range
      iterations_of_settling(const Scene &scene, const Parameters &parameters)
      {
        if (!scene.is_fabric() ||
            !parameters.restart.initial_configuration.empty())
          return {};
        constexpr unsigned int many_fibers = 500;
        SceneEstimate::Range   result(40., 300.);
        if (scene.friction() && parameters.settle.friction)
          result = scene.space().n_fibers() > many_fibers
                     ? SceneEstimate::Range(80., 300.)
                     : SceneEstimate::Range(30., 200.);
        if (scene.weave() && parameters.weave.description().start ==
                               Textile::Start::interpenetrating)
          {
            const double ordering =
              parameters.ordering.n_steps * parameters.ordering.iterations;
            result.first += ordering;
            result.second += ordering;
          }
        return result;
      }



      /** Nobody waits for more, nor for more to be counted. */
      constexpr unsigned int most_steps = 1000000;

      /** Steps of a plan of which so many iterations are taken each. */
      double
      count_steps(const Solver::LoadPlan &plan, const unsigned int iterations)
      {
        unsigned int         n = 0;
        Solver::LoadStepping steps(plan);
        for (; n < most_steps && !steps.finished(); ++n)
          steps.accept(iterations);
        return n;
      }



      SceneEstimate::Range
      count_load_steps(const Scene &scene)
      {
        SceneEstimate::Range result(0., 0.);
        for (const Stage &stage : scene.stages())
          if (stage.is_loaded())
            {
              const unsigned int easy = stage.plan.easy_iterations;
              result.first += count_steps(stage.plan, easy);
              result.second += count_steps(stage.plan, easy + 1);
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
      seconds           = seconds_of_iteration(scene,
                                     is_factorized,
                                     /*under_load=*/true,
                                     3. * matrix.n_nodes);
      seconds_to_settle = seconds_of_iteration(
        scene,
        parameters.linear_solver.direct(scene.space().n_dofs(),
                                        /*with_contact=*/true,
                                        /*with_matrix=*/false),
        /*under_load=*/false,
        /*n_matrix_dofs=*/0.);
      iterations_to_settle = iterations_of_settling(scene, parameters);
      load_steps           = count_load_steps(scene);
      iterations_of_step   = scene.is_fabric() && !parameters.plates.are_there()
                               ? Range(4., 16.)
                               : Range(3., 60.);
    }



    SceneEstimate::Range
    SceneEstimate::total() const
    {
      return {iterations_to_settle.first * seconds_to_settle +
                load_steps.first * iterations_of_step.first * seconds,
              iterations_to_settle.second * seconds_to_settle +
                load_steps.second * iterations_of_step.second * seconds};
    }
  } // namespace Simulation
} // namespace Heddle
