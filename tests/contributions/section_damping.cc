// Sections are held back while they turn by more than a limit in an iteration,
// 0.1 rad where friction resists it and 0.005 where nothing does, and let go
// fiber by fiber below it, threefold at most in each iteration and to a
// thousandth. Positions are not held back, nor is anything that is a force.
#include <heddle/base/petsc.h>
#include <heddle/contributions/section_damping.h>
#include <heddle/system/block_system.h>

#include "scene.h"

/** Two fibers, of which the first one turns and the second does not. */
class Pair : public Scene
{
public:
  explicit Pair(const bool with_friction)
    : damping(with_friction)
  {
    fibers.element_name = "director";
    fibers.degree       = 1;
    const Tensor<1, 3> along({1., 0., 0.}), beside({0., 1., 0.});
    build({straight_path({}, along, /*n_knots=*/5, /*radius=*/0.1),
           straight_path(beside, beside + along, 5, 0.1)});
    system = std::make_unique<System::BlockSystem>(*state);
    System::BlockPattern pattern(state->n_owned_blocks());
    for (unsigned int b = 0; b < state->n_owned_blocks(); ++b)
      pattern.couple(1, &b);
    system->set_pattern(pattern);
    system->set_constraints({});
    damping.begin_step(*state);
  }

  /** What holds block @p block of fiber @p fiber back, and what acts on it. */
  std::pair<double, double>
  stiffness_and_force(const unsigned int fiber, const unsigned int block)
  {
    system->begin(System::BlockSystem::Want::residual_and_tangent);
    damping.assemble(*state, *system);
    system->end();
    std::vector<Tensor<1, 3>> forces;
    system->unbalanced(forces);

    const unsigned int index = state->local_block(fiber) + block;
    Vec unit = system->solution(), row = system->right_hand_side();
    petsc(VecSet(unit, 0.));
    petsc(VecSetValue(unit, 3 * index, 1., INSERT_VALUES));
    petsc(VecAssemblyBegin(unit));
    petsc(VecAssemblyEnd(unit));
    petsc(MatMult(system->tangent(), unit, row));
    double stiffness;
    petsc(VecDot(unit, row, &stiffness));
    return {stiffness, forces[index].norm()};
  }

  /** An iteration in which a section of the first fiber turns [rad]. */
  void
  turn(const double angle)
  {
    System::Increment increment(state->n_local_blocks());
    increment[state->local_block(0) + 4][2] = angle;
    damping.predict(*state, increment);
  }

private:
  Contributions::SectionDamping        damping;
  std::unique_ptr<System::BlockSystem> system;
};



void
test(const bool with_friction, const double angle)
{
  Pair         pair(with_friction);
  const double first = pair.stiffness_and_force(0, 1).first;
  deallog << (with_friction ? "with" : "without") << " friction, " << angle
          << " rad: the first fiber keeps";
  for (unsigned int i = 0; i < 8; ++i)
    {
      pair.turn(angle);
      deallog << ' ' << pair.stiffness_and_force(0, 1).first / first;
    }
  deallog << ", the second " << pair.stiffness_and_force(1, 1).first / first
          << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest              mpi(argc, argv);
  Pair                 pair(/*with_friction=*/true);
  const System::Fiber &fiber = pair.space->fiber(0);
  deallog << "Stiffness of a section, of E A L / nodes: "
          << pair.stiffness_and_force(0, 1).first * fiber.n_nodes /
               (fiber.section.axial * fiber.length)
          << std::endl;
  deallog << "Stiffness of a position " << pair.stiffness_and_force(0, 0).first
          << ", force on it " << pair.stiffness_and_force(0, 0).second
          << ", on a section " << pair.stiffness_and_force(0, 1).second
          << std::endl;
  for (const bool with_friction : {true, false})
    for (const double angle : {1., 0.05, 0.02, 0.004, 0.001})
      test(with_friction, angle);
}
