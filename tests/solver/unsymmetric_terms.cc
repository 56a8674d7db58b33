// A tangent that is a symmetric matrix and unsymmetric terms beside it: with
// constraints in frames of their own, some of which prescribe a motion, the
// factorization finds what LU finds of one matrix that has all of it. So does
// GMRES where the terms are strong; where they are so weak that conjugate
// gradients leave no more than 0.2 of the right-hand side in the energy
// norm, these are left alone.
#include <heddle/solver/linear_solver.h>

#include "../contributions/scene.h"

#include <iostream>

constexpr unsigned int n_fibers = 5, n_knots = 7;

using Motion = std::vector<Tensor<1, 3>>;

/** Fibers beside each other, tied at their nodes. */
class Tied : public Scene
{
public:
  Tied(const std::string &element)
  {
    fibers.element_name = element;
    std::vector<Textile::FiberPath> paths;
    for (unsigned int f = 0; f < n_fibers; ++f)
      {
        const Tensor<1, 3> begin({0., 0.25 * f, 0.});
        paths.push_back(straight_path(
          begin, begin + Tensor<1, 3>({6., 0., 0.}), n_knots, 0.1));
      }
    build(paths);
    std::vector<System::GhostFiber> foreign;
    for (unsigned int f = 0; f < n_fibers; ++f)
      if (!space->owns(f))
        foreign.push_back({f, space->all_nodes(f)});
    state->set_ghost_fibers(foreign);
  }

  /**
   * The system with terms of strength @p drag: where a fiber comes nearer to
   * the next one it is dragged along it. They are part of the matrix if it is
   * not @p symmetric.
   */
  std::unique_ptr<System::BlockSystem>
  assemble(const double drag, const bool symmetric) const
  {
    auto system = std::make_unique<System::BlockSystem>(*state, symmetric);
    System::BlockPattern pattern(state->n_owned_blocks());
    for (const auto &contribution : contributions)
      contribution->add_pattern(*state, pattern);
    for_each_tie(
      [&](const unsigned int *blocks) { pattern.couple(2, blocks); });
    system->set_pattern(pattern);
    system->set_constraints(constraints());
    system->begin(System::BlockSystem::Want::residual_and_tangent);
    for (const auto &contribution : contributions)
      contribution->assemble(*state, *system);
    for_each_tie([&](const unsigned int *blocks) {
      const Tensor<1, 3> force({drag, 0., 0.1 * drag}), motion({0.1, 1., 0.});
      const double       signs[2]    = {1., -1.};
      double             tangent[36] = {};
      for (unsigned int i = 0; i < 6; ++i)
        {
          tangent[7 * i] += 1.;
          tangent[6 * i + (i + 3) % 6] -= 1.;
          for (unsigned int j = 0; j < 6 && !symmetric; ++j)
            tangent[6 * i + j] +=
              signs[i / 3] * force[i % 3] * signs[j / 3] * motion[j % 3];
        }
      const double forces[6] = {0.1, 0., 0.3, 0., 0.2, -0.1};
      system->add(2, blocks, forces, tangent);
      if (!symmetric)
        return;
      System::UnsymmetricTerms &terms = system->unsymmetric_terms();
      terms.begin_term(motion);
      for (unsigned int i = 0; i < 2; ++i)
        terms.add_motion(blocks[i], signs[i]);
      terms.begin_force(force);
      for (unsigned int i = 0; i < 2; ++i)
        terms.add_force(blocks[i], signs[i]);
    });
    for (unsigned int b = 0; b < state->n_owned_blocks(); ++b)
      system->add_diagonal(b, 0.1);
    system->end();
    return system;
  }

private:
  /** Call @p action(blocks) for ties of own fibers. */
  template <typename Action>
  void
  for_each_tie(const Action &action) const
  {
    const unsigned int n = space->n_blocks_per_node();
    for (unsigned int f = 0; f + 1 < n_fibers; ++f)
      if (space->owns(f) || space->owns(f + 1))
        for (unsigned int node = 0; node < n_knots; ++node)
          {
            const unsigned int blocks[2] = {state->local_block(f) + n * node,
                                            state->local_block(f + 1) +
                                              n * node};
            action(blocks);
          }
  }

  /** Both ends of all fibers, one component of one of them moves. */
  std::vector<System::Constraint>
  constraints() const
  {
    std::vector<System::Constraint> result;
    const double                    c = std::cos(0.4), s = std::sin(0.4);
    const Tensor<2, 3>              frame(
      {{c, s, 0.}, {-s * c, c * c, s}, {s * s, -s * c, c}});
    for (unsigned int f = 0; f < n_fibers; ++f)
      for (const unsigned int node : {0u, n_knots - 1})
        result.push_back(
          {state->local_block(f) + node * space->n_blocks_per_node(),
           {{true, f != 2, node == 0}},
           frame,
           {{f == 3 ? 0.2 : 0., 0., 0.}}});
    return result;
  }
};



Motion
solve(const std::string         &kind,
      const System::BlockSystem &system,
      Solver::LinearResult      &result)
{
  Solver::LinearSolverParameters parameters("/Linear solver of " + kind);
  parameters.kind      = kind;
  parameters.tolerance = 1e-10;
  Solver::LinearSolver solver(parameters, system);
  result = solver.solve(/*exactly=*/false);
  Motion motion;
  system.extract_increment(motion);
  return motion;
}



double
distance(const Motion &a, const Motion &b)
{
  double sum = 0., size = 0.;
  for (unsigned int i = 0; i < a.size(); ++i)
    {
      sum += (a[i] - b[i]).norm_square();
      size += b[i].norm_square();
    }
  return std::sqrt(Utilities::MPI::sum(sum, MPI_COMM_WORLD) /
                   Utilities::MPI::sum(size, MPI_COMM_WORLD));
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  for (const std::string element : {"hermite", "director"})
    {
      const Tied           scene(element);
      Solver::LinearResult all, factorized, improved, alone;
      for (const auto &[drag, bound] :
           {std::pair(0., 1e-7), {1e-3, 1e-4}, {30., 1e-7}, {100., 1e-7}})
        {
          const auto   one      = scene.assemble(drag, /*symmetric=*/false);
          const auto   system   = scene.assemble(drag, /*symmetric=*/true);
          const Motion exact    = solve("direct", *one, all);
          const double error[2] = {
            distance(solve("direct", *system, factorized), exact),
            distance(solve("fiber blocks", *system, improved), exact)};
          if (drag == 0.)
            alone = improved;
          if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
            std::cout << "iterations " << improved.iterations << ", errors "
                      << error[0] << ' ' << error[1] << std::endl;
          deallog << element << ", drag " << drag << ": factorized as by LU "
                  << (error[0] < 1e-8) << ", conjugate gradients "
                  << (improved.iterations == alone.iterations ? "alone"
                                                              : "and GMRES")
                  << ' ' << (error[1] < bound) << std::endl;
        }
    }
}
