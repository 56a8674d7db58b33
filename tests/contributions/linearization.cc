// One Newton step from a disturbed configuration, with prescribed motions along
// the axes and in a frame that lies askew, dead forces and moments: the
// residual vanishes to first order in all that is free, judged by differences,
// and what is held moves as told. Errors as a part of the residual.
#include <heddle/solver/linear_solver.h>

#include "scene.h"

#include <random>

using System::BlockSystem;



std::unique_ptr<Scene>
make_scene(const std::string &element)
{
  auto scene                  = std::make_unique<Scene>();
  scene->fibers.element_name  = element;
  scene->fibers.degree        = 2;
  scene->fibers.axial_modulus = 1e3;
  scene->clamp("first end");
  auto &turned           = scene->add_support();
  turned.nodes.nodes     = "last end";
  turned.displacement[1] = "0.3*t";
  turned.section         = "turned";
  turned.angle           = "t";
  turned.axis            = Tensor<1, 3>({1., 2., 3.});
  auto &load             = scene->add_load();
  load.nodes.nodes       = "all";
  load.force             = {{"1", "2", "x"}};
  load.moment            = {{"2", "1", "-1"}};
  scene->build({straight_path(Tensor<1, 3>(),
                              Tensor<1, 3>({0.6, 0.8, 0.}),
                              9,
                              /*radius=*/0.1)});
  return scene;
}



std::vector<Tensor<1, 3>>
residual(Scene &scene, BlockSystem &system)
{
  system.begin(BlockSystem::Want::residual);
  for (const auto &contribution : scene.contributions)
    contribution->assemble(*scene.state, system);
  std::vector<Tensor<1, 3>> forces;
  system.unbalanced(forces);
  return forces;
}



void
test(const std::string &element)
{
  const auto     scene = make_scene(element);
  System::State &state = *scene->state;
  state.load_factor    = 1.;
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
  for (const auto &contribution : scene->contributions)
    {
      contribution->begin_step(state);
      contribution->add_pattern(state, pattern);
      contribution->constrain(state, constraints);
    }
  system.set_pattern(pattern);
  system.set_constraints(constraints);
  system.begin(BlockSystem::Want::residual_and_tangent);
  for (const auto &contribution : scene->contributions)
    contribution->assemble(state, system);
  system.end();
  std::vector<Tensor<1, 3>> start;
  system.unbalanced(start);
  Solver::LinearSolver solver(scene->linear, system);
  solver.solve(true);
  System::Increment step;
  system.extract_increment(step);

  const double h = 1e-5;
  state.move(h, step);
  const auto forward = residual(*scene, system);
  state.move(-2. * h, step);
  const auto backward = residual(*scene, system);
  double     rest = 0., scale = 0.;
  for (unsigned int b = 0; b < start.size(); ++b)
    {
      const auto change = (forward[b] - backward[b]) / (2. * h);
      rest              = std::max(rest, (start[b] + change).norm());
      scale             = std::max(scale, start[b].norm());
    }
  state.move(1. + h, step);
  constraints.clear();
  scene->contributions[1]->constrain(state, constraints);
  double pending = 0.;
  for (const auto &constraint : constraints)
    for (const double motion : constraint.pending)
      pending = std::max(pending, std::abs(motion));
  deallog << element << ": " << constraints.size()
          << " blocks held; first-order balance "
          << (rest < 1e-6 * scale ? "holds" : "FAIL ") << ", held motion "
          << (pending < 1e-12 ? "exact" : "FAIL") << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  test("hermite");
  test("director");
}
