// What keeps Newton's method from going astray: sections are held back, and
// elements that are turned back on themselves are objected to.
#include <heddle/base/choice.h>
#include <heddle/base/petsc.h>
#include <heddle/contributions/section_damping.h>
#include <heddle/system/block_system.h>

#include "scene.h"

#include <functional>

/** Two fibers, of which the first one turns and the second does not. */
class Pair : public Scene
{
public:
  explicit Pair(const bool with_friction)
    : damping(with_friction)
  {
    fibers.element_kind = Heddle::Beam::ElementKind::director;
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



/**
 * Sections are held back while they turn by more than a limit in an iteration,
 * 0.1 rad where friction resists it and 0.005 where nothing does, and let go
 * fiber by fiber below it, threefold at most in each iteration and to a
 * thousandth. Positions are not held back, nor is anything that is a force.
 */
void
sections_held_back()
{
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



/** Where a particle of the straight fiber, 8 mm long, goes. */
using Motion = std::function<Tensor<1, 3>(const double)>;

void
examine(const std::string &element,
        const std::string &name,
        const Motion      &motion)
{
  Scene scene;
  scene.fibers.element_kind =
    Heddle::choice<Heddle::Beam::ElementKind>(element);
  auto path = straight_path({}, Tensor<1, 3>({8., 0., 0.}), 9, 0.25);
  for (unsigned int i = 0; i < path.points.size(); ++i)
    path.points[i] = motion(i);
  scene.build({straight_path({}, Tensor<1, 3>({8., 0., 0.}), 9, 0.25)});
  scene.state->set(Simulation::place_on_paths(*scene.space, {path}));
  const std::string objection =
    scene.contributions.front()->objection(*scene.state);
  deallog << element << ", " << name << ": "
          << (objection.empty() ? "nothing" : objection) << std::endl;
}



/**
 * Two nodes that changed places turn the element between them back on itself:
 * that is objected to, as is any compression by more than 0.3. A strain of 0.8
 * is none, nor is a fiber that is bent to a ring of five times its radius.
 */
void
objections()
{
  for (const std::string element : {"hermite", "director"})
    {
      const auto along = [](const double x) {
        return Tensor<1, 3>({x, 0., 0.});
      };
      examine(element, "straight", along);
      examine(element, "bent to a ring", [](const double x) {
        const double angle = 2. * numbers::PI * x / 8.;
        return 8. / (2. * numbers::PI) *
               Tensor<1, 3>({std::sin(angle), 1. - std::cos(angle), 0.});
      });
      examine(element, "compressed by 0.2", [&](const double x) {
        return along(0.8 * x);
      });
      examine(element, "stretched by 0 to 0.64", [&](const double x) {
        return along(x + 0.04 * x * x);
      });
      examine(element, "compressed by 0 to 0.48", [&](const double x) {
        return along(x - 0.03 * x * x);
      });
      examine(element, "two nodes changed places", [&](const double x) {
        return along(x == 3. || x == 4. ? 7. - x : x);
      });
    }
}



int
main(int argc, char **argv)
{
  const MPITest mpi(argc, argv);
  run_part("Sections that are held back", sections_held_back);
  run_part("Objections", objections);
}
