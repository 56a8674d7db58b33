// A tangent without a factorization is told from others, and the next one is
// factorized again: PETSc's interface to MUMPS would go on with the failed one.
#include <heddle/solver/linear_solver.h>

#include "../contributions/scene.h"

int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  Scene   scene;
  scene.fibers.elements_per_fiber = 4;
  scene.build(
    {straight_path({}, Tensor<1, 3>({1., 0., 0.}), 5, 0.1),
     straight_path(
       Tensor<1, 3>({0., 1., 0.}), Tensor<1, 3>({1., 1., 0.}), 5, 0.1)});
  const System::State &state = *scene.state;

  System::BlockSystem  system(state);
  System::BlockPattern pattern(state.n_owned_blocks());
  system.set_pattern(pattern);
  Solver::LinearSolverParameters parameters;
  parameters.kind = "direct";
  Solver::LinearSolver solver(parameters, system);
  for (const double stiffness : {1., 0., 0., 2.})
    {
      system.begin(System::BlockSystem::Want::residual_and_tangent);
      for (unsigned int b = 0; b < state.n_owned_blocks(); ++b)
        {
          const double force[3] = {-1., -1., -1.}, none[9] = {};
          system.add(1, &b, force, none);
          system.add_diagonal(b, stiffness);
        }
      system.end();
      const Solver::LinearResult result = solver.solve(true);
      deallog << "stiffness " << stiffness << ": singular " << result.singular;
      if (!result.singular)
        {
          std::vector<Tensor<1, 3>> increment;
          system.extract_increment(increment);
          deallog << ", increment times stiffness "
                  << increment.front()[0] * stiffness;
        }
      deallog << std::endl;
    }
}
