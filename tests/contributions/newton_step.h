#ifndef heddle_tests_contributions_newton_step_h
#define heddle_tests_contributions_newton_step_h

#include <heddle/solver/linear_solver.h>

#include "scene.h"

#include <random>

using System::BlockSystem;



/** What one Newton step leaves of the forces, to first order. */
struct NewtonStep
{
  std::vector<Tensor<1, 3>>       before; /**< unbalanced forces */
  std::vector<Tensor<1, 3>>       rest;   /**< of them after the step */
  std::vector<System::Constraint> constraints;
};



template <typename SceneType>
std::vector<Tensor<1, 3>>
unbalanced_forces(SceneType &scene, BlockSystem &system)
{
  system.begin(BlockSystem::Want::residual);
  for (const auto &contribution : scene.contributions)
    contribution->assemble(*scene.state, system);
  std::vector<Tensor<1, 3>> forces;
  system.unbalanced(forces);
  return forces;
}



/**
 * Disturb a scene, and take one Newton step with its whole tangent: what is
 * left of the forces to first order is judged by differences along the step.
 */
template <typename SceneType>
NewtonStep
take_newton_step(SceneType &scene)
{
  System::State                         &state = *scene.state;
  std::mt19937                           generator(1);
  std::uniform_real_distribution<double> uniform(-0.02, 0.02);
  System::Increment                      disturbance(state.n_local_blocks());
  for (Tensor<1, 3> &block : disturbance)
    for (unsigned int d = 0; d < 3; ++d)
      block[d] = uniform(generator);
  state.move(1., disturbance);

  NewtonStep           result;
  BlockSystem          system(state);
  System::BlockPattern pattern(state.n_owned_blocks());
  for (const auto &contribution : scene.contributions)
    {
      contribution->begin_step(state);
      contribution->add_pattern(state, pattern);
      contribution->constrain(state, result.constraints);
    }
  system.set_pattern(pattern);
  system.set_constraints(result.constraints);
  system.begin(BlockSystem::Want::residual_and_tangent);
  for (const auto &contribution : scene.contributions)
    contribution->assemble(state, system);
  system.end();
  system.unbalanced(result.before);
  Solver::LinearSolver solver(scene.linear, system);
  solver.solve();
  System::Increment step;
  system.extract_increment(step);

  const double h = 1e-5;
  state.move(h, step);
  const auto forward = unbalanced_forces(scene, system);
  state.move(-2. * h, step);
  const auto backward = unbalanced_forces(scene, system);
  state.move(1. + h, step);
  for (unsigned int b = 0; b < result.before.size(); ++b)
    result.rest.push_back(result.before[b] +
                          (forward[b] - backward[b]) / (2. * h));
  return result;
}



/** The largest of the @p forces of the blocks [begin, end). */
inline double
largest(const std::vector<Tensor<1, 3>> &forces,
        const unsigned int               begin,
        const unsigned int               end)
{
  double result = 0.;
  for (unsigned int b = begin; b < end; ++b)
    result = std::max(result, forces[b].norm());
  return result;
}

#endif
