// A tangent that is a symmetric matrix and unsymmetric terms beside it: with
// constraints in frames of their own, some of which prescribe a motion, the
// factorization finds the motion that balances the forces of both, summed term
// by term here, and moves what is held as told. So does GMRES where the terms
// are strong; where they are so weak that conjugate gradients leave no more
// than 0.2 of the right-hand side in the energy norm, these are left alone.
#include <heddle/base/choice.h>
#include <heddle/solver/linear_solver.h>

#include "../contributions/scene.h"

#include <iostream>

constexpr unsigned int n_fibers = 5, n_knots = 7;

using Motion = std::vector<Tensor<1, 3>>;

/** Motion towards the next fiber, and the force that it raises. */
const Tensor<1, 3> nearer({0.1, 1., 0.}), dragged({1., 0., 0.1});

/** Fibers beside each other, tied at their nodes. */
class Tied : public Scene
{
public:
  Tied(const std::string &element)
  {
    fibers.element_kind = Heddle::choice<Heddle::Beam::ElementKind>(element);
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
   * the next one it is dragged along it.
   */
  std::unique_ptr<System::BlockSystem>
  assemble(const double drag, const bool constrained) const
  {
    auto                 system = std::make_unique<System::BlockSystem>(*state);
    System::BlockPattern pattern(state->n_owned_blocks());
    for (const auto &contribution : contributions)
      contribution->add_pattern(*state, pattern);
    for_each_tie(
      [&](const unsigned int *blocks) { pattern.couple(2, blocks); });
    system->set_pattern(pattern);
    if (constrained)
      system->set_constraints(constraints());
    system->begin(System::BlockSystem::Want::residual_and_tangent);
    for (const auto &contribution : contributions)
      contribution->assemble(*state, *system);
    for_each_tie([&](const unsigned int *blocks) {
      double tangent[36] = {};
      for (unsigned int i = 0; i < 6; ++i)
        {
          tangent[7 * i] += 1.;
          tangent[6 * i + (i + 3) % 6] -= 1.;
        }
      const double forces[6] = {0.1, 0., 0.3, 0., 0.2, -0.1};
      system->add(2, blocks, forces, tangent);
      System::UnsymmetricTerms &terms = system->unsymmetric_terms();
      terms.begin_term(nearer);
      terms.add_motion(blocks[0], 1.);
      terms.add_motion(blocks[1], -1.);
      terms.begin_force(drag * dragged);
      terms.add_force(blocks[0], 1.);
      terms.add_force(blocks[1], -1.);
    });
    for (unsigned int b = 0; b < state->n_owned_blocks(); ++b)
      system->add_diagonal(b, 0.1);
    system->end();
    return system;
  }

  /**
   * The largest force that this @p motion leaves where it is free, over the
   * largest there is, or how far it is from what is prescribed.
   */
  double
  imbalance(const double drag, const Motion &motion) const
  {
    const auto         symmetric = assemble(/*drag=*/0., /*constrained=*/false);
    const unsigned int n_owned   = state->n_owned_blocks();
    Motion             forces    = symmetric->residual();
    double             scale     = 0.;
    for (const Tensor<1, 3> &force : forces)
      scale = std::max(scale, force.norm());
    scale = Utilities::MPI::max(scale, MPI_COMM_WORLD);

    const Vec vector = symmetric->solution(),
              raised = symmetric->right_hand_side();
    double *values;
    VecGetArray(vector, &values);
    for (unsigned int i = 0; i < 3 * n_owned; ++i)
      values[i] = motion[i / 3][i % 3];
    VecRestoreArray(vector, &values);
    MatMult(symmetric->tangent(), vector, raised);
    VecGetArray(raised, &values);
    for (unsigned int i = 0; i < 3 * n_owned; ++i)
      forces[i / 3][i % 3] += values[i];
    VecRestoreArray(raised, &values);
    for_each_tie([&](const unsigned int *blocks) {
      const double approach = nearer * (motion[blocks[0]] - motion[blocks[1]]);
      for (unsigned int i = 0; i < 2; ++i)
        if (blocks[i] < n_owned)
          forces[blocks[i]] += (i == 0 ? 1. : -1.) * drag * approach * dragged;
    });

    double left = 0.;
    for (const System::Constraint &constraint : constraints())
      if (constraint.block < n_owned)
        {
          const Tensor<1, 3> moved =
            constraint.frame * motion[constraint.block];
          Tensor<1, 3> &force = forces[constraint.block];
          force               = constraint.frame * force;
          for (unsigned int d = 0; d < 3; ++d)
            if (constraint.fixed[d])
              {
                left =
                  std::max(left, std::abs(moved[d] - constraint.pending[d]));
                force[d] = 0.;
              }
        }
    for (const Tensor<1, 3> &force : forces)
      left = std::max(left, force.norm() / scale);
    return Utilities::MPI::max(left, MPI_COMM_WORLD);
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
  parameters.kind      = Heddle::choice<Heddle::Solver::LinearSolverKind>(kind);
  parameters.tolerance = 1e-10;
  Solver::LinearSolver solver(parameters, system);
  result = solver.solve({/*exactly=*/false});
  Motion motion;
  system.extract_increment(motion);
  return motion;
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  for (const std::string element : {"hermite", "director"})
    {
      const Tied           scene(element);
      Solver::LinearResult factorized, improved, alone;
      for (const auto &[drag, bound] :
           {std::pair(0., 1e-7), {1e-3, 1e-3}, {30., 1e-7}, {100., 1e-7}})
        {
          const auto   system  = scene.assemble(drag, /*constrained=*/true);
          const double left[2] = {
            scene.imbalance(drag, solve("direct", *system, factorized)),
            scene.imbalance(drag, solve("fiber blocks", *system, improved))};
          if (drag == 0.)
            alone = improved;
          if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
            std::cout << "iterations " << improved.iterations << ", left "
                      << left[0] << ' ' << left[1] << std::endl;
          deallog << element << ", drag " << drag << ": factorized in balance "
                  << (left[0] < 1e-8) << ", conjugate gradients "
                  << (improved.iterations == alone.iterations ? "alone"
                                                              : "and GMRES")
                  << ' ' << (left[1] < bound) << std::endl;
        }
    }
}
