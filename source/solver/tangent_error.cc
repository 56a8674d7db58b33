#include <heddle/base/petsc.h>
#include <heddle/solver/tangent_error.h>
#include <heddle/solver/tangent_operator.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <random>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      using System::BlockSystem;
      using System::Increment;

      /** Of all fibers at random, by a @p size in radii: section vectors, and
       * tangents, have no unit. */
      Increment
      random_motion(const System::State &state,
                    const double         size,
                    std::mt19937        &generator)
      {
        std::uniform_real_distribution<double> uniform(-size, size);
        const System::FiberSpace              &space = state.space;
        const auto                             owned = space.owned_fibers();
        Increment                              motion(state.n_local_blocks());
        for (unsigned int f = owned.first; f < owned.second; ++f)
          for (unsigned int b = 0;
               b < space.fiber(f).n_nodes * space.n_blocks_per_node();
               ++b)
            for (unsigned int d = 0; d < 3; ++d)
              motion[state.local_block(f) + b][d] =
                uniform(generator) * (b % space.n_blocks_per_node() == 0
                                        ? space.fiber(f).radius
                                        : 1.);
        state.update_ghosts(motion);
        return motion;
      }



      /** What the assembled tangent makes of @p motion. */
      std::vector<Tensor<1, 3>>
      product(const BlockSystem &system, const Increment &motion)
      {
        const TangentOperator tangent(system, BlockSystem::Part::whole);
        Vec                   input, output;
        petsc(MatCreateVecs(tangent.matrix(), &input, &output));
        double *values;
        petsc(VecGetArray(input, &values));
        const unsigned int n_blocks = system.state.n_owned_blocks();
        for (unsigned int b = 0; b < n_blocks; ++b)
          std::copy_n(motion[b].begin_raw(), 3, values + 3 * b);
        petsc(VecRestoreArray(input, &values));
        petsc(MatMult(tangent.matrix(), input, output));
        std::vector<Tensor<1, 3>> result(n_blocks);
        const double             *forces;
        petsc(VecGetArrayRead(output, &forces));
        for (unsigned int b = 0; b < n_blocks; ++b)
          std::copy_n(forces + 3 * b, 3, result[b].begin_raw());
        petsc(VecRestoreArrayRead(output, &forces));
        petsc(VecDestroy(&input));
        petsc(VecDestroy(&output));
        return result;
      }
    } // namespace



    double
    tangent_error(const std::shared_ptr<System::Contribution> &term,
                  System::State                               &state,
                  const double                                 motion)
    {
      constexpr double     distance     = 1e-2;
      const NonsmoothTerms terms        = nonsmooth_terms({term});
      const MPI_Comm       communicator = state.space.communicator();
      std::mt19937         generator(1 +
                             Utilities::MPI::this_mpi_process(communicator));
      state.move(1., random_motion(state, distance, generator));

      for (System::NonsmoothContribution *nonsmooth : terms)
        {
          nonsmooth->update(state);
          nonsmooth->begin_iteration(state);
        }
      BlockSystem          system(state);
      System::BlockPattern pattern(state.n_owned_blocks());
      term->add_pattern(state, pattern);
      system.set_pattern(pattern);
      system.set_constraints({});
      system.begin(BlockSystem::Want::residual_and_tangent);
      term->assemble(state, system);
      system.end();

      const Increment along    = random_motion(state, motion, generator);
      const auto      told     = product(system, along);
      const auto      residual = [&]() {
        for (System::NonsmoothContribution *nonsmooth : terms)
          nonsmooth->update_trial(state);
        system.begin(BlockSystem::Want::residual);
        term->assemble(state, system);
        system.end();
        return system.residual();
      };
      state.move(1., along);
      const auto forward = residual();
      state.move(-2., along);
      const auto backward = residual();

      double largest = 0., difference = 0.;
      for (unsigned int b = 0; b < told.size(); ++b)
        {
          const Tensor<1, 3> found = 0.5 * (forward[b] - backward[b]);
          largest    = std::max({largest, found.norm(), told[b].norm()});
          difference = std::max(difference, (found - told[b]).norm());
        }
      largest    = Utilities::MPI::max(largest, communicator);
      difference = Utilities::MPI::max(difference, communicator);
      return largest == 0. ? 0. : difference / largest;
    }
  } // namespace Solver
} // namespace Heddle
