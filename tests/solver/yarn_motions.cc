// The coarse correction M = P (P^T A P)^-1 P^T of motions in which all fibers
// of a yarn move alike: M A w = w for all that it can say, as there are w = M r
// of random r and the translation of one yarn; nothing for a yarn of one fiber.
// With yarns that are held weakly, conjugate gradients need fewer iterations
// than if each fiber is a yarn for itself.
#include <heddle/base/choice.h>
#include <heddle/base/petsc.h>
#include <heddle/solver/linear_solver.h>
#include <heddle/solver/yarn_motions.h>

#include "../contributions/scene.h"

#include <iostream>
#include <random>

constexpr unsigned int n_knots = 13;

/** Two yarns of four fibers across each other, and a fiber for itself. */
class Yarns : public Scene
{
public:
  Yarns(const std::string &element, const bool alone)
  {
    fibers.element_kind = Heddle::choice<Heddle::Beam::ElementKind>(element);
    linear.kind         = Heddle::Solver::LinearSolverKind::fiber_blocks;
    linear.tolerance    = 1e-8;
    std::vector<Textile::FiberPath> paths;
    for (unsigned int f = 0; f < 9; ++f)
      {
        const double       across = 0.25 * (f % 4);
        const Tensor<1, 3> begin  = f < 4 ? Tensor<1, 3>({0., across, 0.})
                                          : Tensor<1, 3>({across, 0., 0.2});
        const Tensor<1, 3> along =
          f < 4 ? Tensor<1, 3>({6., 0., 0.}) : Tensor<1, 3>({0., 6., 0.});
        paths.push_back(straight_path(begin, begin + along, n_knots, 0.1));
        paths.back().yarn_id = alone ? f : f / 4;
      }
    build(paths);
    std::vector<System::GhostFiber> foreign;
    for (unsigned int f = 0; f < space->n_fibers(); ++f)
      if (!space->owns(f))
        foreign.push_back({f, space->all_nodes(f)});
    state->set_ghost_fibers(foreign);
    system = std::make_unique<System::BlockSystem>(*state);

    // Neighbours are tied along a yarn, yarns weakly, to the ground hardly.
    System::BlockPattern pattern(state->n_owned_blocks());
    for (const auto &contribution : contributions)
      contribution->add_pattern(*state, pattern);
    for_each_spring([&](const unsigned int *blocks, const double) {
      pattern.couple(2, blocks);
    });
    system->set_pattern(pattern);
    system->begin(System::BlockSystem::Want::residual_and_tangent);
    for (const auto &contribution : contributions)
      contribution->assemble(*state, *system);
    for_each_spring([&](const unsigned int *blocks, const double stiffness) {
      double tangent[36] = {};
      for (unsigned int i = 0; i < 6; ++i)
        {
          tangent[7 * i]               = stiffness;
          tangent[6 * i + (i + 3) % 6] = -stiffness;
        }
      const double forces[6] = {0., 0., stiffness, 0., 0., 0.};
      system->add(2, blocks, forces, tangent);
    });
    for (unsigned int b = 0; b < state->n_owned_blocks(); ++b)
      system->add_diagonal(b, 1e-3);
    system->end();
  }

  /** Call @p action(blocks, stiffness) for springs that touch own fibers. */
  template <typename Action>
  void
  for_each_spring(const Action &action) const
  {
    const unsigned int n = space->n_blocks_per_node();
    for (unsigned int f = 0; f + 1 < space->n_fibers(); ++f)
      if (space->owns(f) || space->owns(f + 1))
        for (unsigned int node = 0; node < n_knots; ++node)
          {
            const unsigned int blocks[2] = {state->local_block(f) + n * node,
                                            state->local_block(f + 1) +
                                              n * node};
            action(blocks, f == 3 ? 1e-2 : 100.);
          }
  }

  std::vector<double>
  image(const std::vector<double> &values) const
  {
    Vec     vector = system->solution(), product = system->right_hand_side();
    double *entries;
    petsc(VecGetArray(vector, &entries));
    std::copy(values.begin(), values.end(), entries);
    petsc(VecRestoreArray(vector, &entries));
    petsc(MatMult(system->tangent(), vector, product));
    petsc(VecGetArray(product, &entries));
    const std::vector<double> result(entries, entries + values.size());
    petsc(VecRestoreArray(product, &entries));
    return result;
  }

  std::unique_ptr<System::BlockSystem> system;
};



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  for (const std::string element : {"hermite", "director"})
    {
      Yarns      yarns(element, /*alone=*/false);
      Yarns      lone(element, /*alone=*/true);
      const auto solve = [](Yarns &scene) {
        Solver::LinearSolver solver(scene.linear, *scene.system);
        return solver.solve({/*exactly=*/false}).iterations;
      };
      const unsigned int together = solve(yarns), apart = solve(lone);

      Solver::YarnMotions motions(*yarns.state);
      motions.set_up(*yarns.system,
                     System::LocalBlocks(yarns.system->tangent()));
      const unsigned int n          = 3 * yarns.state->n_owned_blocks();
      const auto         correction = [&](const std::vector<double> &residual) {
        std::vector<double> result(n, 0.);
        AssertThrow(motions.add_correction(residual.data(), result.data()) == 0,
                    ExcInternalError());
        return result;
      };
      const auto error = [&](const std::vector<double> &motion) {
        const std::vector<double> again      = correction(yarns.image(motion));
        double                    difference = 0.;
        for (unsigned int i = 0; i < n; ++i)
          difference = std::max(difference, std::abs(again[i] - motion[i]));
        return Utilities::MPI::max(difference, MPI_COMM_WORLD);
      };
      const auto size = [&](const std::vector<double> &values,
                            const unsigned int         fiber) {
        double largest = 0.;
        if (yarns.space->owns(fiber))
          for (unsigned int i = 0; i < 3 * yarns.space->n_blocks(fiber); ++i)
            largest = std::max(
              largest,
              std::abs(values[3 * yarns.state->local_block(fiber) + i]));
        return Utilities::MPI::max(largest, MPI_COMM_WORLD);
      };

      std::mt19937                           generator(1);
      std::uniform_real_distribution<double> number(-1., 1.);
      std::vector<double>                    residual(n), translation(n, 0.);
      for (double &value : residual)
        value = number(generator);
      for (unsigned int f = 4; f < 8; ++f)
        if (yarns.space->owns(f))
          for (unsigned int node = 0; node < n_knots; ++node)
            translation[3 * (yarns.state->local_block(f) +
                             node * yarns.space->n_blocks_per_node()) +
                        1] = 1.;
      const auto motion = correction(residual);
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        std::cout << element << ": iterations " << together << ", " << apart
                  << std::endl;
      deallog << element << ": random "
              << (error(motion) < 1e-9 * size(motion, 0)) << ", translation "
              << (error(translation) < 1e-9) << ", fiber for itself "
              << size(motion, 8) << ", fewer iterations "
              << (3 * together < 2 * apart) << std::endl;
    }
}
