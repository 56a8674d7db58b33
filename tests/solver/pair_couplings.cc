// What couples particles, of two fibers or of a coil, by contact and by
// friction is the same beside the matrix as in it: products with the tangent
// and what prescribed motion raises, with constraints in frames of their own;
// how parts of yarns move; and what conjugate gradients find. Beside it no
// pattern grows old: when the fibers have found others to touch it still has
// all places, but for friction of the torsion-free element, which asks for
// another one.
#include <heddle/base/choice.h>
#include <heddle/base/petsc.h>
#include <heddle/contributions/fiber_friction.h>
#include <heddle/solver/linear_solver.h>
#include <heddle/solver/tangent_operator.h>
#include <heddle/solver/terms.h>

#include "../contributions/scene.h"

#include <iostream>
#include <random>

constexpr unsigned int n_knots = 13;

using Motion = std::vector<Tensor<1, 3>>;

/** Two turns that lie in each other, far from all else. */
Textile::FiberPath
coil()
{
  constexpr unsigned int n_intervals = 2 * (n_knots - 1);
  Textile::FiberPath     path;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    {
      const double turns = 2. * i / n_intervals,
                   angle = 2. * numbers::PI * turns;
      path.points.push_back(Tensor<1, 3>(
        {0.8 * std::cos(angle), 0.8 * std::sin(angle), 3. + 0.19 * turns}));
    }
  path.reference_length = 4. * numbers::PI * 0.8;
  path.radius           = 0.1;
  return path;
}



/**
 * Two crossing yarns of three fibers that lie in each other, a fiber beside
 * them and a coil.
 */
class Crossing : public Scene
{
public:
  Crossing(const std::string &element)
  {
    fibers.element_kind = Heddle::choice<Heddle::Beam::ElementKind>(element);
    linear.kind         = Heddle::Solver::LinearSolverKind::fiber_blocks;
    linear.tolerance    = 1e-10;
    parameters.friction = 0.3;
    parameters.reversible_displacement = 0.01;
    std::vector<Textile::FiberPath> paths;
    for (unsigned int f = 0; f < 7; ++f)
      {
        const double       across = 0.19 * (f % 3) - 0.19;
        const Tensor<1, 3> middle = f < 3   ? Tensor<1, 3>({0., across, 0.})
                                    : f < 6 ? Tensor<1, 3>({across, 0., 0.19})
                                            : Tensor<1, 3>({0., 0.1, -0.16});
        const Tensor<1, 3> along  = f < 3 || f == 6
                                      ? Tensor<1, 3>({1., 0., 0.})
                                      : Tensor<1, 3>({0.2, 1., 0.});
        paths.push_back(straight_path(
          middle - 2. * along, middle + 2. * along, n_knots, 0.1));
        paths.back().yarn_id = f / 3;
      }
    paths.push_back(coil());
    paths.back().yarn_id = paths.size() / 3;
    build(paths);
    contact = std::make_shared<Contributions::FiberContact>(*space, parameters);
    friction = std::make_shared<Contributions::FiberFriction>(
      *space, parameters, *contact);
    contributions.push_back(contact);
    contributions.push_back(friction);
    for (const auto &contribution : contributions)
      contribution->begin_step(*state);
    move(1., 0.004);
  }

  /** Move all blocks by @p drift along, and at random, and look for contact. */
  void
  move(const double drift, const double size)
  {
    Motion motion(state->n_owned_blocks());
    for (unsigned int f = 0; f < space->n_fibers(); ++f)
      for (unsigned int b = 0; b < space->n_blocks(f); ++b)
        {
          // All ranks draw the same numbers.
          const Tensor<1, 3> random(
            {number(generator), number(generator), number(generator)});
          if (space->owns(f))
            {
              motion[state->local_block(f) + b] = size * random;
              if (f < 3 && b % space->n_blocks_per_node() == 0)
                motion[state->local_block(f) + b][0] += 0.01 * drift;
            }
        }
    motion.resize(state->n_local_blocks());
    state->update_ghosts(motion);
    state->move(1., motion);
    for (auto *term : Solver::nonsmooth_terms(contributions))
      term->update(*state);
  }

  std::unique_ptr<System::BlockSystem>
  assemble(const bool apart)
  {
    auto system = std::make_unique<System::BlockSystem>(*state, apart);
    System::BlockPattern pattern(state->n_owned_blocks(), apart);
    for (const auto &contribution : contributions)
      contribution->add_pattern(*state, pattern);
    system->set_pattern(pattern);
    fill(*system);
    return system;
  }

  /** Assemble into places that are there. */
  void
  fill(System::BlockSystem &system)
  {
    system.set_constraints(constraints());
    system.begin(System::BlockSystem::Want::residual_and_tangent);
    for (const auto &contribution : contributions)
      contribution->assemble(*state, system);
    for (unsigned int b = 0; b < state->n_owned_blocks(); ++b)
      system.add_diagonal(b, 10.);
    system.end();
  }

  bool
  needs_new_pattern(const System::NonsmoothContribution &contribution) const
  {
    return Utilities::MPI::max(contribution.needs_new_pattern() ? 1 : 0,
                               MPI_COMM_WORLD) > 0;
  }

  /** Whether the coil touches itself. */
  bool
  touches_itself() const
  {
    const auto &elements = contact->elements();
    const bool  any =
      std::any_of(elements.begin(), elements.end(), [](const auto &element) {
        return element.fiber_a == element.fiber_b && element.force > 0.;
      });
    return Utilities::MPI::max(any ? 1 : 0, MPI_COMM_WORLD) > 0;
  }

  Contact::ContactParameters                    parameters;
  std::shared_ptr<Contributions::FiberContact>  contact;
  std::shared_ptr<Contributions::FiberFriction> friction;

private:
  /**
   * Both ends of all fibers and, where they touch, a node of two of them; one
   * component of one end and of that node moves.
   */
  std::vector<System::Constraint>
  constraints() const
  {
    std::vector<System::Constraint> result;
    const double                    c = std::cos(0.4), s = std::sin(0.4);
    const Tensor<2, 3>              frame(
      {{c, s, 0.}, {-s * c, c * c, s}, {s * s, -s * c, c}});
    for (unsigned int f = 0; f < space->n_fibers(); ++f)
      for (const unsigned int node : {0u, n_knots / 2, n_knots - 1})
        if (state->has(f) && (node != n_knots / 2 || f == 1 || f == 4))
          {
            const auto         held = state->held_blocks(f);
            const unsigned int block =
              state->local_block(f) + node * space->n_blocks_per_node();
            if (block >= held.first && block < held.second)
              result.push_back({block,
                                {{true, f != 2, node == 0}},
                                frame,
                                {{f == 3 || f == 1 ? 0.02 : 0., 0., 0.}}});
          }
    return result;
  }

  std::mt19937                           generator{1};
  std::uniform_real_distribution<double> number{-1., 1.};
};



using Numbers = std::vector<double>;

Numbers
entries(Vec vector)
{
  PetscInt n;
  petsc(VecGetLocalSize(vector, &n));
  const double *values;
  petsc(VecGetArrayRead(vector, &values));
  const Numbers result(values, values + n);
  petsc(VecRestoreArrayRead(vector, &values));
  return result;
}



/** A part of the tangent times sin 1, sin 2, sin 3, ... of the rank. */
Numbers
product(const System::BlockSystem &system, const System::BlockSystem::Part part)
{
  const Solver::TangentOperator tangent(system, part);
  Vec                           vector, image;
  petsc(VecDuplicate(system.solution(), &vector));
  petsc(VecDuplicate(system.solution(), &image));
  double  *values;
  PetscInt n;
  petsc(VecGetLocalSize(vector, &n));
  petsc(VecGetArray(vector, &values));
  for (PetscInt i = 0; i < n; ++i)
    values[i] = std::sin(i + 1.);
  petsc(VecRestoreArray(vector, &values));
  petsc(MatMult(tangent.matrix(), vector, image));
  const Numbers result = entries(image);
  petsc(VecDestroy(&vector));
  petsc(VecDestroy(&image));
  return result;
}



/** The correction of the forces sin 1, sin 2, sin 3, ... */
Numbers
correction(const Crossing &scene, const System::BlockSystem &system)
{
  Solver::YarnMotions motions(*scene.state);
  motions.set_up(system, System::LocalBlocks(system.tangent()));
  Numbers forces(3 * scene.state->n_owned_blocks()), result(forces.size(), 0.);
  for (unsigned int i = 0; i < forces.size(); ++i)
    forces[i] = std::sin(i + 1.);
  AssertThrow(motions.add_correction(forces.data(), result.data()) == 0,
              ExcInternalError());
  return result;
}



Numbers
solution(const Crossing &scene, const System::BlockSystem &system)
{
  Solver::LinearSolver solver(scene.linear, system);
  solver.solve({/*exactly=*/false});
  return entries(system.solution());
}



/** Largest difference over the largest number, on all ranks. */
double
difference(const Numbers &a, const Numbers &b)
{
  double apart = 0., size = 0.;
  for (unsigned int i = 0; i < a.size(); ++i)
    {
      apart = std::max(apart, std::abs(a[i] - b[i]));
      size  = std::max(size, std::abs(b[i]));
    }
  size = Utilities::MPI::max(size, MPI_COMM_WORLD);
  AssertThrow(size > 0., ExcInternalError());
  return Utilities::MPI::max(apart, MPI_COMM_WORLD) / size;
}



void
print(const std::string &element, const double *errors, const unsigned int n)
{
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) > 0)
    return;
  std::cout << element << ": errors";
  for (unsigned int i = 0; i < n; ++i)
    std::cout << ' ' << errors[i];
  std::cout << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  using Part = System::BlockSystem::Part;
  for (const std::string element : {"hermite", "director"})
    {
      Crossing     scene(element);
      const auto   within   = scene.assemble(/*apart=*/false);
      auto         beside   = scene.assemble(/*apart=*/true);
      const double errors[] = {
        difference(product(*beside, Part::symmetric),
                   product(*within, Part::symmetric)),
        difference(product(*beside, Part::whole),
                   product(*within, Part::whole)),
        difference(entries(beside->right_hand_side()),
                   entries(within->right_hand_side())),
        difference(correction(scene, *beside), correction(scene, *within)),
        difference(solution(scene, *beside), solution(scene, *within))};
      print(element, errors, 5);
      deallog << element << ": beside the matrix "
              << beside->has_couplings_apart() << within->has_couplings_apart()
              << ", coil touches itself " << scene.touches_itself()
              << ", symmetric product " << (errors[0] < 1e-12) << ", whole "
              << (errors[1] < 1e-12) << ", right-hand side "
              << (errors[2] < 1e-12) << ", motion of yarns "
              << (errors[3] < 1e-9) << ", solution " << (errors[4] < 1e-6)
              << std::endl;

      // The yarns slide over each other by two elements. On several ranks
      // blocks may have other numbers then.
      const unsigned int version = scene.state->ghost_version();
      scene.move(70., 0.);
      const bool contact_asks  = scene.needs_new_pattern(*scene.contact),
                 friction_asks = scene.needs_new_pattern(*scene.friction);
      if (contact_asks || friction_asks ||
          scene.state->ghost_version() != version)
        beside = scene.assemble(/*apart=*/true);
      else
        scene.fill(*beside);
      const Numbers later   = product(*beside, Part::whole);
      const double  after[] = {difference(
        later, product(*scene.assemble(/*apart=*/false), Part::whole))};
      scene.move(-70., 0.);
      print(element, after, 1);
      deallog << element << ": new pattern within "
              << scene.needs_new_pattern(*scene.contact) << ", beside "
              << contact_asks << friction_asks << ", whole product "
              << (after[0] < 1e-12) << std::endl;
    }
}
