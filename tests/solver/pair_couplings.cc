// What couples two fibers, by contact and by friction, is the same beside the
// matrix as in it: products with the tangent and what prescribed motion raises,
// with constraints in frames of their own; how whole yarns move; and what
// conjugate gradients find. Beside it no pattern grows old: none is asked for
// when the fibers have found others to touch, as it is where they are in it.
#include <heddle/base/petsc.h>
#include <heddle/contributions/fiber_friction.h>
#include <heddle/solver/linear_solver.h>
#include <heddle/solver/tangent_operator.h>

#include "../contributions/scene.h"

#include <iostream>
#include <random>

constexpr unsigned int n_knots = 13;

using Motion = std::vector<Tensor<1, 3>>;

/** Two crossing yarns of three fibers that lie in each other, and one beside.
 */
class Crossing : public Scene
{
public:
  Crossing(const std::string &element)
  {
    fibers.element_name                = element;
    linear.kind                        = "fiber blocks";
    linear.tolerance                   = 1e-10;
    parameters.friction                = 0.3;
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
    for (const auto &contribution : contributions)
      contribution->update(*state);
  }

  std::unique_ptr<System::BlockSystem>
  assemble(const bool apart)
  {
    auto system = std::make_unique<System::BlockSystem>(*state,
                                                        /*symmetric=*/true,
                                                        apart);
    System::BlockSystem::Pattern pattern(state->n_owned_blocks(), apart);
    for (const auto &contribution : contributions)
      contribution->add_pattern(*state, pattern);
    system->set_pattern(pattern);
    system->set_constraints(constraints());
    system->begin(System::BlockSystem::Want::residual_and_tangent);
    for (const auto &contribution : contributions)
      contribution->assemble(*state, *system);
    for (unsigned int b = 0; b < state->n_owned_blocks(); ++b)
      system->add_diagonal(b, 10.);
    system->end();
    return system;
  }

  Contact::ContactParameters                    parameters;
  std::shared_ptr<Contributions::FiberContact>  contact;
  std::shared_ptr<Contributions::FiberFriction> friction;

private:
  /**
   * Both ends of all fibers and, where they touch, a node of two of them; one
   * component of one end and of that node moves.
   */
  std::vector<System::BlockSystem::Constraint>
  constraints() const
  {
    std::vector<System::BlockSystem::Constraint> result;
    const double       c = std::cos(0.4), s = std::sin(0.4);
    const Tensor<2, 3> frame(
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



/** A part of the tangent times the numbers 1, 2, 3, ... of the rank. */
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



/** The correction of the forces 1, 2, 3, ... */
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
  solver.solve(/*exactly=*/false);
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



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  using Part = System::BlockSystem::Part;
  for (const std::string element : {"hermite", "director"})
    {
      Crossing     scene(element);
      const auto   beside   = scene.assemble(/*apart=*/true);
      const bool   stays    = !scene.contact->needs_new_pattern();
      const auto   within   = scene.assemble(/*apart=*/false);
      const double errors[] = {
        difference(product(*beside, Part::symmetric),
                   product(*within, Part::symmetric)),
        difference(product(*beside, Part::whole),
                   product(*within, Part::whole)),
        difference(entries(beside->right_hand_side()),
                   entries(within->right_hand_side())),
        difference(correction(scene, *beside), correction(scene, *within))};
      const double of_solution =
        difference(solution(scene, *beside), solution(scene, *within));
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        std::cout << element << ": errors " << errors[0] << ' ' << errors[1]
                  << ' ' << errors[2] << ' ' << errors[3] << ' ' << of_solution
                  << std::endl;
      deallog << element << ": beside the matrix "
              << beside->has_couplings_apart() << within->has_couplings_apart()
              << ", symmetric product " << (errors[0] < 1e-12) << ", whole "
              << (errors[1] < 1e-12) << ", right-hand side "
              << (errors[2] < 1e-12) << ", motion of yarns "
              << (errors[3] < 1e-9) << ", solution " << (of_solution < 1e-6)
              << std::endl;

      // The yarns slide over each other by two elements.
      scene.move(70., 0.);
      const bool old = scene.contact->needs_new_pattern();
      scene.assemble(/*apart=*/true);
      scene.move(-70., 0.);
      deallog << element << ": new pattern within "
              << Utilities::MPI::max(old ? 1 : 0, MPI_COMM_WORLD) << ", beside "
              << !stays << scene.contact->needs_new_pattern() << std::endl;
    }
}
