// Newton's method with a tangent that is not that of the energy, corrected by
// what steps tell. After each step the corrected system makes of the change of
// forces that step. With exact line searches it ends after as many steps as
// there are unknowns, where the tangent alone is far from there, and what it is
// given to solve is as it was. A step along which forces do not change tells
// nothing, one that was not taken neither.
#include <heddle/base/petsc.h>
#include <heddle/solver/secants.h>

#include "../tests.h"

#include <cmath>
#include <random>
#include <vector>

using Heddle::petsc;

constexpr PetscInt n = 8;

/** The energy u A u / 2 - b u and a diagonal tangent, larger than A. */
class Problem
{
public:
  Problem()
    : stiffness(n * n, 0.)
  {
    for (Vec *vector : {&u, &b, &rhs, &solution, &work})
      petsc(VecCreateMPI(MPI_COMM_WORLD, PETSC_DECIDE, n, vector));
    std::mt19937                           random(1);
    std::uniform_real_distribution<double> between(-1., 1.);
    std::vector<double>                    root(n * n);
    for (double &value : root)
      value = between(random);
    for (PetscInt i = 0; i < n; ++i)
      for (PetscInt j = 0; j < n; ++j)
        for (PetscInt k = 0; k < n; ++k)
          stiffness[n * i + j] += root[n * i + k] * root[n * j + k];
    for (PetscInt i = 0; i < n; ++i)
      petsc(VecSetValue(b, i, between(random), INSERT_VALUES));
    petsc(VecAssemblyBegin(b));
    petsc(VecAssemblyEnd(b));
  }

  ~Problem()
  {
    for (Vec *vector : {&u, &b, &rhs, &solution, &work})
      VecDestroy(vector);
  }

  void
  multiply(Vec from, Vec to) const
  {
    const double *x;
    double       *y;
    petsc(VecGetArrayRead(from, &x));
    petsc(VecGetArray(to, &y));
    for (PetscInt i = 0; i < n; ++i)
      {
        y[i] = 0.;
        for (PetscInt j = 0; j < n; ++j)
          y[i] += stiffness[n * i + j] * x[j];
      }
    petsc(VecRestoreArray(to, &y));
    petsc(VecRestoreArrayRead(from, &x));
  }

  /** Unbalanced forces b - A u; return their norm. */
  double
  set_right_hand_side()
  {
    multiply(u, rhs);
    petsc(VecAYPX(rhs, -1., b));
    return norm(rhs);
  }

  static double
  norm(Vec vector)
  {
    double value;
    petsc(VecNorm(vector, NORM_2, &value));
    return value;
  }

  /** By the tangent, whose entries are 3, 4, ... */
  void
  solve()
  {
    const double *x;
    double       *y;
    petsc(VecGetArrayRead(rhs, &x));
    petsc(VecGetArray(solution, &y));
    for (PetscInt i = 0; i < n; ++i)
      y[i] = x[i] / (3. + i);
    petsc(VecRestoreArray(solution, &y));
    petsc(VecRestoreArrayRead(rhs, &x));
  }

  /** Where the energy along the solution is least. */
  double
  best_part()
  {
    double slope, curvature;
    multiply(solution, work);
    petsc(VecDot(solution, rhs, &slope));
    petsc(VecDot(solution, work, &curvature));
    return slope / curvature;
  }

  std::vector<double> stiffness;
  Vec                 u, b, rhs, solution, work;
};



/** Return the unbalanced forces after @p n_steps, over those before. */
double
converge(const bool corrected, const unsigned int n_steps)
{
  Problem                 problem;
  Heddle::Solver::Secants secants;
  const double            before = problem.set_right_hand_side();
  double                  after = before, error = 0., changed = 0.;
  for (unsigned int step = 0; step < n_steps; ++step)
    {
      if (corrected)
        {
          secants.observe(problem.rhs);
          secants.reduce(problem.rhs);
        }
      problem.solve();
      if (corrected)
        secants.complete(problem.rhs, problem.solution);

      // The right-hand side is what it was.
      Vec whole;
      petsc(VecDuplicate(problem.rhs, &whole));
      petsc(VecCopy(problem.rhs, whole));
      problem.set_right_hand_side();
      petsc(VecAXPY(whole, -1., problem.rhs));
      changed = std::max(changed, Problem::norm(whole));
      petsc(VecDestroy(&whole));

      const double part = problem.best_part();
      petsc(VecAXPY(problem.u, part, problem.solution));
      if (corrected)
        secants.take(part, problem.solution);

      // The change of forces along the step, A s, asks for s.
      petsc(VecScale(problem.solution, part));
      Vec motion;
      petsc(VecDuplicate(problem.solution, &motion));
      petsc(VecCopy(problem.solution, motion));
      after = problem.set_right_hand_side();
      if (corrected && after > 1e-10 * before)
        {
          secants.observe(problem.rhs);
          problem.multiply(motion, problem.rhs);
          secants.reduce(problem.rhs);
          problem.solve();
          secants.complete(problem.rhs, problem.solution);
          petsc(VecAXPY(problem.solution, -1., motion));
          error = std::max(
            error, Problem::norm(problem.solution) / Problem::norm(motion));
          problem.set_right_hand_side();
        }
      petsc(VecDestroy(&motion));
    }
  if (corrected)
    deallog << "changes of forces ask for the steps: " << (error < 1e-10)
            << ", right-hand sides are restored: " << (changed == 0.)
            << std::endl;
  return after / before;
}



/** What tells nothing leaves a solution as it is. */
void
nothing_learned()
{
  Problem                 problem;
  Heddle::Solver::Secants secants;
  for (const double taken : {0., 1.})
    {
      problem.set_right_hand_side();
      for (unsigned int i = 0; i < 2; ++i)
        {
          secants.observe(problem.rhs);
          secants.reduce(problem.rhs);
          problem.solve();
          secants.complete(problem.rhs, problem.solution);
          secants.take(taken, problem.solution);
        }
      Vec corrected;
      petsc(VecDuplicate(problem.solution, &corrected));
      petsc(VecCopy(problem.solution, corrected));
      problem.solve();
      petsc(VecAXPY(corrected, -1., problem.solution));
      deallog << "part " << taken << " taken, forces as before: other by "
              << Problem::norm(corrected) << std::endl;
      petsc(VecDestroy(&corrected));
    }
}



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  initlog();
  const double by_tangent = converge(false, n), corrected = converge(true, n);
  deallog << "after " << n << " steps by the tangent more than 1e-3 is left: "
          << (by_tangent > 1e-3)
          << ", corrected less than 1e-8: " << (corrected < 1e-8) << std::endl;
  nothing_learned();
}
