// One Newton step of a fiber in a matrix from a disturbed configuration, by the
// whole tangent: the residual vanishes to first order, judged by differences,
// in the fiber as well as in the matrix. For the laws of the matrix, elements
// of the fiber, links in nodes and at points between them.
#include <heddle/solver/linear_solver.h>

#include "../verification/composite.h"

#include <random>

using System::BlockSystem;



std::vector<Tensor<1, 3>>
residual(Composite &scene, BlockSystem &system)
{
  system.begin(BlockSystem::Want::residual);
  for (const auto &contribution : scene.contributions)
    contribution->assemble(*scene.state, system);
  std::vector<Tensor<1, 3>> forces;
  system.unbalanced(forces);
  return forces;
}



void
test(const std::string &element,
     const std::string &law,
     const unsigned int n_points)
{
  Composite scene(
    mesh(3, 2, Tensor<1, 3>({3., 1., 1.})) + " set Law = " + law +
    "\n set Coupling points per element = " + std::to_string(n_points) +
    "\n set Coupling stiffness factor = 20\n");
  scene.fibers.element_name       = element;
  scene.fibers.axial_modulus      = 100.;
  scene.hold({"x-"}).displacement = {{"0", "0", "0"}};
  scene.embed({straight_path(Tensor<1, 3>({0.1, 0.2, 0.3}),
                             Tensor<1, 3>({2.8, 0.9, 0.6}),
                             9,
                             /*radius=*/0.1)});
  System::State                         &state = *scene.state;
  std::mt19937                           generator(1);
  std::uniform_real_distribution<double> uniform(-0.02, 0.02);
  System::Increment                      disturbance(state.n_local_blocks());
  for (Tensor<1, 3> &block : disturbance)
    for (unsigned int d = 0; d < 3; ++d)
      block[d] = uniform(generator);
  state.move(1., disturbance);

  BlockSystem                          system(state, /*symmetric=*/false);
  BlockSystem::Pattern                 pattern(state.n_owned_blocks());
  std::vector<BlockSystem::Constraint> constraints;
  for (const auto &contribution : scene.contributions)
    {
      contribution->begin_step(state);
      contribution->add_pattern(state, pattern);
      contribution->constrain(state, constraints);
    }
  system.set_pattern(pattern);
  system.set_constraints(constraints);
  system.begin(BlockSystem::Want::residual_and_tangent);
  for (const auto &contribution : scene.contributions)
    contribution->assemble(state, system);
  system.end();
  std::vector<Tensor<1, 3>> start;
  system.unbalanced(start);
  Solver::LinearSolver solver(scene.linear, system);
  solver.solve(true);
  System::Increment step;
  system.extract_increment(step);

  const double h = 1e-5;
  state.move(h, step);
  const auto forward = residual(scene, system);
  state.move(-2. * h, step);
  const auto backward = residual(scene, system);
  double     of_fiber = 0., of_matrix = 0., scale = 0.;
  for (unsigned int b = 0; b < start.size(); ++b)
    {
      const auto change = (forward[b] - backward[b]) / (2. * h);
      double    &rest = b < state.n_owned_fiber_blocks() ? of_fiber : of_matrix;
      rest            = std::max(rest, (start[b] + change).norm());
      scale           = std::max(scale, start[b].norm());
    }
  print(element + ", " + law + ", fiber", n_points, of_fiber / scale);
  print(element + ", " + law + ", matrix", n_points, of_matrix / scale);
  deallog << element << ", " << law << ", " << n_points
          << " points: first-order balance of the fiber "
          << (of_fiber < 1e-6 * scale ? "holds" : "FAIL") << ", of the matrix "
          << (of_matrix < 1e-6 * scale ? "holds" : "FAIL") << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  for (const std::string element : {"hermite", "director"})
    for (const std::string law :
         {"linear", "st venant-kirchhoff", "neo-hookean"})
      for (const unsigned int n_points : {0, 2})
        test(element, law, n_points);
}
