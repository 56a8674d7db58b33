// Fibers in an elastic matrix: conjugate gradients find the increment that a
// factorization finds, and Newton's method takes as many iterations. The bound
// on linear iterations is met by a symmetric sweep over the nodes of the matrix
// (186 for each of Newton's at most), not by its diagonal (267 at least). Where
// they do not converge, here for want of iterations, the system is factorized.
#include <heddle/simulation/matrix.h>

#include "../contributions/scene.h"

#include <algorithm>
#include <iostream>

/** Six fibers across each other in a block that is pulled and sheared. */
class Composite : public Scene
{
public:
  Composite(const std::string &kind, const unsigned int degree)
    : parameters("/Matrix " + std::to_string(++n_scenes))
  {
    std::ostringstream entries;
    entries << "subsection Matrix " << n_scenes
            << "\n set Shape = block\n set Leave out cells inside yarns = false"
               "\n set Lower corner = 0, 0, 0\n set Upper corner = 4, 4, 1"
               "\n set Law = neo-hookean\n set Youngs modulus = 10"
               "\n set Poisson ratio = 0.45\n set Degree = "
            << degree << "\n set Columns x = " << 12 / degree
            << "\n set Columns y = " << 12 / degree
            << "\n set Layers = " << 4 / degree << "\nend\n";
    ParameterAcceptor::prm.parse_input_from_string(entries.str());
    ParameterAcceptor::parse_all_parameters();

    fibers.element_name  = "director";
    fibers.axial_modulus = 1000.;
    linear.kind          = kind;
    linear.tolerance     = 1e-10;
    auto &foot           = add_support();
    foot.nodes.nodes     = "first end";
    foot.matrix_sides    = {"x-"};
    foot.displacement    = {{"0", "0", "0"}};
    foot.section         = "held";
    auto &pull           = add_support();
    pull.nodes.fibers    = "none";
    pull.matrix_sides    = {"x+"};
    pull.displacement    = {{"0.2", "0.1", "0.05"}};

    std::vector<Textile::FiberPath> paths;
    for (const double across : {0.7, 2.1, 3.3})
      {
        paths.push_back(straight_path(Tensor<1, 3>({0., across, 0.3}),
                                      Tensor<1, 3>({3.9, across, 0.35}),
                                      9,
                                      0.05));
        paths.push_back(straight_path(Tensor<1, 3>({across, 0.1, 0.7}),
                                      Tensor<1, 3>({across, 3.9, 0.65}),
                                      9,
                                      0.05));
      }
    build(paths);
    matrix = std::make_unique<Simulation::Matrix>(parameters, *state);
    contributions.push_back(matrix->elasticity());
    contributions.push_back(matrix->coupling());
    for (const auto &contribution : contributions)
      contribution->begin_stage(*state);
  }

  std::unique_ptr<Simulation::Matrix> matrix;

private:
  static unsigned int          n_scenes;
  Simulation::MatrixParameters parameters;
};

unsigned int Composite::n_scenes = 0;



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  {
    Composite unfinished("fiber blocks", 1);
    unfinished.linear.max_iterations = 3;
    const auto result                = unfinished.solve(1.);
    deallog << "three iterations: converged " << result.converged
            << ", factorizations "
            << (result.factorizations == result.iterations) << std::endl;
  }
  for (const unsigned int degree : {1, 2})
    {
      Composite  exact("direct", degree), iterative("fiber blocks", degree);
      const auto expected = exact.solve(1.), result = iterative.solve(1.);
      double     error = 0., largest = 0.;
      for (unsigned int b = 0; b < exact.state->n_owned_blocks(); ++b)
        {
          error = std::max(
            error,
            (exact.state->current()[b] - iterative.state->current()[b]).norm());
          largest = std::max(
            largest,
            (exact.state->current()[b] - exact.state->accepted()[b]).norm());
        }
      error   = Utilities::MPI::max(error, MPI_COMM_WORLD);
      largest = Utilities::MPI::max(largest, MPI_COMM_WORLD);
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        std::cout << "iterations of Newton " << expected.iterations << ", "
                  << result.iterations << ", linear "
                  << result.linear_iterations << ", error " << error
                  << std::endl;
      deallog << "degree " << degree << ": converged " << expected.converged
              << result.converged << ", as many iterations "
              << (expected.iterations == result.iterations)
              << ", factorizations "
              << (expected.factorizations == expected.iterations)
              << (result.factorizations == 0) << ", the same "
              << (error < 1e-6 * largest) << ", linear iterations bounded "
              << (result.linear_iterations < 220 * result.iterations)
              << std::endl;
    }
}
