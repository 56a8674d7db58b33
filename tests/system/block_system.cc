// The block system is the sum of its terms: random ones, assembled by the ranks
// that have a part in them, have the product, the right-hand side and the
// increment of the dense sum, with what couples fibers in the matrix or beside
// it, with unsymmetric terms, and with constraints in frames of their own. The
// matrix has the blocks of its pattern, and the pattern what was asked for.
#include <heddle/base/petsc.h>

#include "reference.h"

#include <cmath>
#include <iostream>

using System::BlockSystem;
using Part = BlockSystem::Part;

/** Largest distance of local blocks from what is expected of them. */
double
error(const Composite &scene, const Vectors &found, const Vectors &expected)
{
  double largest = 0.;
  for (unsigned int b = 0; b < found.size(); ++b)
    largest =
      std::max(largest, (found[b] - expected[scene.of_local[b]]).norm());
  return Utilities::MPI::max(largest, MPI_COMM_WORLD);
}



/** The same of the owned blocks in a vector of the system. */
double
error(const Composite &scene, Vec vector, const Vectors &expected)
{
  Vectors       found(scene.state.n_owned_blocks());
  const double *values;
  petsc(VecGetArrayRead(vector, &values));
  for (unsigned int i = 0; i < 3 * found.size(); ++i)
    found[i / 3][i % 3] = values[i];
  petsc(VecRestoreArrayRead(vector, &values));
  return error(scene, found, expected);
}



void
write(const Composite &scene, const Vectors &of_all, Vec vector)
{
  double *values;
  petsc(VecGetArray(vector, &values));
  for (unsigned int i = 0; i < 3 * scene.state.n_owned_blocks(); ++i)
    values[i] = of_all[scene.of_local[i / 3]][i % 3];
  petsc(VecRestoreArray(vector, &values));
}



double
product_error(const Composite   &scene,
              const BlockSystem &system,
              const Reference   &reference,
              const Part         part,
              const Vectors     &x)
{
  const Vec     vector = system.solution();
  const double *input;
  double       *output;
  Vec           image;
  petsc(VecDuplicate(vector, &image));
  write(scene, x, vector);
  petsc(MatMult(system.tangent(), vector, image));
  petsc(VecGetArrayRead(vector, &input));
  petsc(VecGetArray(image, &output));
  system.add_product_of_terms(part, input, output);
  petsc(VecRestoreArray(image, &output));
  petsc(VecRestoreArrayRead(vector, &input));
  const double result = error(scene, image, reference.product(part, x));
  petsc(VecDestroy(&image));
  return result;
}



/** Pairs of blocks that the matrix stores, one half of it. */
unsigned int
n_stored_pairs(const BlockSystem &system)
{
  MatInfo info;
  petsc(MatGetInfo(system.tangent(), MAT_GLOBAL_SUM, &info));
  return std::lround(info.nz_used / 9.);
}



/** Errors of all that is read from a system. */
struct Errors
{
  Errors(Composite &scene, BlockSystem &system, const Reference &reference)
  {
    const Vectors x = scene.terms.draw_vectors();
    const Vectors free =
      reference.without_fixed(reference.in_frames(scene.terms.forces));
    residual = error(scene, system.residual(), scene.terms.forces);
    right_hand_side =
      error(scene, system.right_hand_side(), reference.right_hand_side());
    symmetric = product_error(scene, system, reference, Part::symmetric, x);
    whole     = product_error(scene, system, reference, Part::whole, x);

    Vectors of_blocks;
    write(scene, x, system.solution());
    system.extract_increment(of_blocks);
    AssertDimension(of_blocks.size(), scene.local.size());
    increment =
      error(scene, of_blocks, reference.in_space(reference.with_pending(x)));

    system.unbalanced(of_blocks);
    system.get_unbalanced(system.solution());
    unbalanced = std::max(error(scene, of_blocks, reference.in_space(free)),
                          error(scene, system.solution(), free));

    const Vectors y = scene.terms.draw_vectors();
    for (unsigned int b = 0; b < y.size(); ++b)
      of_blocks[scene.local[b]] = y[b];
    system.replace_increment(of_blocks);
    const Vectors in_frames = reference.in_frames(y);
    replaced                = std::max(
      error(scene, system.solution(), reference.without_fixed(in_frames)),
      error(scene,
            of_blocks,
            reference.in_space(reference.with_pending(in_frames))));
  }

  double residual, unbalanced, right_hand_side, symmetric, whole, increment,
    replaced;
};



void
check(const std::string &element, const bool apart, const bool constrained)
{
  Composite  scene(element);
  const auto constraints = constrained ? scene.terms.draw_constraints()
                                       : std::vector<System::Constraint>();
  auto       of_local    = constraints;
  for (System::Constraint &constraint : of_local)
    constraint.block = scene.local[constraint.block];
  BlockSystem system(scene.state, apart);
  set_pattern(scene, system);
  system.set_constraints(of_local);

  // What was assembled before leaves no trace, and residuals alone leave the
  // tangent as it is.
  assemble(scene, BlockSystem::Want::residual_and_tangent, system);
  assemble(scene, BlockSystem::Want::residual_and_tangent, system);
  assemble(scene, BlockSystem::Want::residual, system);

  const Reference reference(scene, constraints);
  const Errors    errors(scene, system, reference);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << "errors " << errors.residual << ' ' << errors.unbalanced << ' '
              << errors.right_hand_side << ' ' << errors.symmetric << ' '
              << errors.whole << ' ' << errors.increment << ' '
              << errors.replaced << std::endl;

  // Local numbers may be others when ghosts have changed.
  bool known = system.has_pattern();
  scene.state.set_ghost_fibers({});
  known = known && !system.has_pattern();
  deallog << element << (apart ? ", couplings apart" : ", all in the matrix")
          << (constrained ? ", constrained" : "") << ": blocks "
          << scene.local.size() << ", pairs stored " << n_stored_pairs(system)
          << " of " << n_coupled_pairs(scene, system) << ", couples ranks "
          << system.couples_ranks() << ", known until ghosts change " << known
          << ", residual " << (errors.residual < 1e-12) << ", unbalanced "
          << (errors.unbalanced < 1e-12) << ", right-hand side "
          << (errors.right_hand_side < 1e-12) << ", symmetric product "
          << (errors.symmetric < 1e-12) << ", whole " << (errors.whole < 1e-12)
          << ", increment " << (errors.increment < 1e-12) << ", another one "
          << (errors.replaced < 1e-12) << std::endl;
}



void
systems()
{
  for (const std::string element : {"hermite", "director"})
    for (const bool apart : {false, true})
      for (const bool constrained : {false, true})
        check(element, apart, constrained);
}



/**
 * Groups of 12 owned and 8 foreign blocks in no order, and rows: each row has
 * its diagonal and what groups and rows with it have, in ascending order.
 */
void
patterns()
{
  constexpr unsigned int n_owned = 12, n_local = 20;
  std::mt19937           generator(5);
  for (const unsigned int n_groups : {0, 1, 4, 12})
    {
      System::BlockPattern                pattern(n_owned);
      std::vector<std::set<unsigned int>> expected(n_owned);
      const auto                          draw = [&](const unsigned int n) {
        Blocks blocks;
        for (unsigned int k = 0; k < n; ++k)
          blocks.push_back(generator() % n_local);
        return blocks;
      };
      for (unsigned int b = 0; b < n_owned; ++b)
        expected[b].insert(b);
      for (unsigned int group = 0; group < n_groups; ++group)
        {
          const Blocks blocks = draw(1 + group % 4);
          pattern.couple(blocks.size(), blocks.data());
          for (const unsigned int b : blocks)
            if (b < n_owned)
              expected[b].insert(blocks.begin(), blocks.end());
        }
      const Blocks of_row = draw(3);
      pattern.add_row(7, of_row.size(), of_row.data());
      expected[7].insert(of_row.begin(), of_row.end());

      const auto   columns = pattern.columns();
      bool         good    = columns.size() == n_owned;
      unsigned int n       = 0;
      for (unsigned int b = 0; good && b < n_owned; ++b)
        {
          good = columns[b] == Blocks(expected[b].begin(), expected[b].end());
          n += columns[b].size();
        }
      deallog << "groups " << n_groups << ": blocks " << n
              << ", those that were asked for " << everywhere(good)
              << std::endl;
    }
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  run_part("Patterns", patterns);
  run_part("Systems", systems);
}
