// Two crossing fibers are pressed together by springs at their ends. Newton's
// method with adapted penalties ends below the penetration threshold, however
// tight, and the contact force is the one of the springs and tends to a limit.
// It begins softly, far from equilibrium; having come near first, only then.
#include <heddle/contributions/fiber_elasticity.h>
#include <heddle/contributions/nodal_springs.h>
#include <heddle/solver/newton.h>

#include "../contact/contact_scene.h"
#include "../tests.h"

#include <sstream>

using Heddle::Contributions::NodalSprings;

constexpr unsigned int n_intervals = 8;

std::shared_ptr<NodalSprings>
springs()
{
  std::vector<NodalSprings::Spring> result;
  for (unsigned int f = 0; f < 2; ++f)
    for (const unsigned int node : {0u, n_intervals})
      {
        const double         s = node == 0 ? -8. : 8.;
        NodalSprings::Spring spring;
        spring.fiber  = f;
        spring.node   = node;
        spring.target = f == 0 ? Tensor<1, 3>({s - 0.7, 0., 0.})
                               : Tensor<1, 3>({0., s + 0.4, 1.});
        for (unsigned int d = 0; d < 3; ++d)
          spring.stiffness[d][d] = 1.;
        result.push_back(spring);
      }
  return std::make_shared<NodalSprings>("springs", result);
}



/** Print where Newton's method comes to by way of these aims. */
void
press(const double threshold, const std::vector<Heddle::Solver::Aim> &aims)
{
  ContactScene::Options options;
  options.threshold = threshold;
  const Tensor<1, 3> x({1., 0., 0.}), y({0., 1., 0.});
  ContactScene       scene({line(Tensor<1, 3>({-8.7, 0., 0.}), x, 16.),
                            line(Tensor<1, 3>({0., -7.6, 1.99}), y, 16.)},
                     {n_intervals, n_intervals},
                     options);
  const auto         elasticity =
    std::make_shared<Heddle::Contributions::FiberElasticity>(
      scene.space, scene.state.current());
  // Shared without owning: the scene keeps it.
  const std::shared_ptr<Heddle::System::Contribution> contact(
    scene.contact.get(), [](auto) {});
  const auto pull = springs();

  Heddle::Solver::NewtonParameters       newton_parameters;
  Heddle::Solver::LinearSolverParameters linear_parameters;
  std::ostringstream                     screen;
  Heddle::Log                            log(MPI_COMM_WORLD, screen);
  Heddle::SectionTimer                   timer;
  Heddle::StopRequest                    stop(MPI_COMM_WORLD);
  Heddle::Solver::Newton                 newton(
    newton_parameters, linear_parameters, MPI_COMM_WORLD, log, timer, stop);
  elasticity->begin_step(scene.state);
  deallog << "threshold " << threshold << ":";
  for (const Heddle::Solver::Aim aim : aims)
    {
      screen.str("");
      const auto result =
        newton.solve(scene.state, {elasticity, pull, contact}, aim);
      deallog << ' ' << (result.converged ? "converged" : result.obstacle)
              << (screen.str().find("softness") == std::string::npos
                    ? ""
                    : " softly")
              << ',';
    }

  scene.forces();
  double pulled = 0.;
  for (const unsigned int node : {0u, n_intervals})
    pulled -= scene.state.fiber(1)[2 * node][2] - 1.;
  deallog << " penetration "
          << (scene.reported("max_penetration_ratio[-]") <= threshold ? "below"
                                                                      : "ABOVE")
          << ", contact force " << 1e3 * scene.force_on(1)[2]
          << "e-3, over force of springs " << -scene.force_on(1)[2] / pulled
          << std::endl;
}



int
main(int argc, char **argv)
{
  using Heddle::Solver::Aim;
  MPITest test(argc, argv);
  deallog << std::setprecision(3);
  for (const double threshold : {0.05, 0.02, 0.01, 0.001})
    press(threshold, {Aim::equilibrium});
  press(0.02, {Aim::calm, Aim::equilibrium_after_calm});
  press(0.02, {Aim::equilibrium_after_calm});
}
