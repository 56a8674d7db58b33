// A force F moves a block that a spring k holds and that is pushed aside in
// proportion to its motion, by kappa >> k, as friction may do. No energy
// belongs to that, and the work of F along the solution is next to nothing.
// Against a resistance c |u|^2 u, which no tangent knows of at first, the
// search takes the first of 1, 1/2, 1/4, ... of the step after which forces are
// as much less out of balance as it asks for; where the tangent is wrong, and
// no part of the step is good, it says so and leaves all as it was. A
// factorization is as good as conjugate gradients with their preconditioner.
#include <heddle/base/choice.h>
#include <heddle/beam/element.h>
#include <heddle/solver/force_search.h>

#include "../tests.h"

using namespace Heddle;

constexpr double force = 1., spring = 1.;

/** What acts on block 0. The other blocks are held by springs. */
class Push : public System::NonsmoothContribution
{
public:
  std::string
  name() const override
  {
    return "push";
  }

  /** It might change the ghosts, and with them what is to be tried next. */
  void
  update(System::State &) override
  {
    deallog << " FAIL: searched anew" << std::endl;
  }

  void
  update_trial(System::State &) override
  {
  }

  std::pair<double, double>
  slope_and_curvature(const System::State &,
                      const System::Increment &) const override
  {
    return {0., 0.};
  }

  void
  assemble(const System::State &state, System::BlockSystem &system) override
  {
    const Tensor<1, 3> u = state.current()[0];
    const Tensor<1, 3> aside({-u[1], u[0], 0.});
    system.add_force(0,
                     Tensor<1, 3>({-force, 0., 0.}) + spring * u +
                       kappa * aside + resistance * u.norm_square() * u);
    if (!system.wants_tangent())
      return;
    for (unsigned int b = 0; b < state.n_owned_blocks(); ++b)
      system.add_diagonal(b, spring);
    System::UnsymmetricTerms &terms = system.unsymmetric_terms();
    for (unsigned int d = 0; d < 2; ++d)
      {
        Tensor<1, 3> motion, raised;
        motion[d]     = 1.;
        raised[1 - d] = (wrong ? -kappa : kappa) * (d == 0 ? 1. : -1.);
        terms.begin_term(motion);
        terms.add_motion(0, 1.);
        terms.begin_force(raised);
        terms.add_force(0, 1.);
      }
  }

  double kappa = 0., resistance = 0.;
  bool   wrong = false; /**< the tangent has the other sign of kappa */
};



/** Unbalanced forces after a part of the step, squared. */
double
unbalanced_square(const Push &push, const double part)
{
  const double       size = spring * spring + push.kappa * push.kappa;
  const Tensor<1, 3> u(
    {part * force * spring / size,
     part * force * (push.wrong ? 1. : -1.) * push.kappa / size,
     0.});
  const double stiff = spring + push.resistance * u.norm_square();
  return std::pow(-force + stiff * u[0] - push.kappa * u[1], 2) +
         std::pow(stiff * u[1] + push.kappa * u[0], 2);
}



/** The part that a search should find. */
double
expected(const Push &push)
{
  for (double part = 1.; part > 0.01; part /= 2.)
    if (unbalanced_square(push, part) <
        (1. - 0.1 * part) * unbalanced_square(push, 0.))
      return part;
  return 0.;
}



void
examine(System::State &state, const std::string &kind, const Push &like)
{
  const auto                  push          = std::make_shared<Push>(like);
  const Solver::Contributions contributions = {push};
  System::BlockSystem         system(state);
  system.set_pattern(System::BlockPattern(state.n_owned_blocks()));
  system.set_constraints({});
  system.begin(System::BlockSystem::Want::residual_and_tangent);
  push->assemble(state, system);
  system.end();

  Solver::LinearSolverParameters parameters("/Linear solver for " + kind);
  parameters.kind      = choice<Solver::LinearSolverKind>(kind);
  parameters.tolerance = 1e-8;
  Solver::LinearSolver solver(parameters, system);
  const auto           result = solver.solve({/*exactly=*/false});
  System::Increment    increment;
  system.extract_increment(increment);

  const double work   = increment[0][0] * force / (force * force / spring);
  const double before = solver.energy_of_residual();
  const auto   start  = state.current();
  const double part   = Solver::step_to_balance(
    state, contributions, system, solver, increment, /*longest=*/10.);
  const double after = solver.energy_of_residual();
  const double ratio =
    unbalanced_square(*push, part) / unbalanced_square(*push, 0.);
  deallog << "  " << kind << ": far from symmetric " << result.unsymmetric
          << ", work along the step below 1e-2 " << (work < 1e-2) << ", part "
          << part << ", as expected " << (part == expected(*push))
          << ", energy as by hand "
          << (!result.unsymmetric || std::abs(after / before - ratio) < 1e-6)
          << ", state as before " << (state.current() == start) << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest                         test(argc, argv);
  System::FiberSpace::Description fiber = {};
  fiber.element_lengths                 = {1.};
  fiber.radius                          = 0.1;
  fiber.section =
    Beam::circular_section(0.1, /*axial=*/1., /*shear=*/0.4, /*poisson=*/0.25);
  const System::FiberSpace space(
    MPI_COMM_WORLD,
    Beam::make_element(Beam::ElementKind::hermite, /*degree=*/3),
    {fiber});
  System::State state(space);

  Push push;
  for (const auto &[kappa, resistance, wrong] : {std::tuple(0.1, 0., false),
                                                 {30., 0., false},
                                                 {30., 3e4, false},
                                                 {30., 1e5, false},
                                                 {30., 1e6, false},
                                                 {30., 0., true}})
    {
      push.kappa      = kappa;
      push.resistance = resistance;
      push.wrong      = wrong;
      deallog << "kappa " << kappa << ", resistance " << resistance
              << ", tangent wrong " << wrong << std::endl;
      for (const std::string kind : {"direct", "fiber blocks"})
        examine(state, kind, push);
    }
}
