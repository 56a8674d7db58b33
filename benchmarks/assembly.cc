// Time to assemble the elements of 288 fibers against the floating-point
// operations that residual, tangent and energy take, and against how fast this
// core multiplies matrices. The driver benchmarks/assembly builds and runs it.

#include <heddle/base/choice.h>
#include <heddle/contributions/fiber_elasticity.h>
#include <heddle/simulation/fiber_placement.h>

#include <deal.II/base/mpi.h>

#include <Eigen/Dense>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <random>
#include <string>

using namespace Heddle;
using namespace dealii;

namespace
{
  constexpr unsigned int n_fibers   = 288;
  constexpr unsigned int n_elements = 36;

  /**
   * Repetitions last so long at least, and the fastest counts: the machine may
   * be shared, and what else runs there comes and goes.
   */
  constexpr double enough_seconds = 0.5;



  /** The shortest time of an action [s]. */
  double
  shortest(const std::function<void()> &action)
  {
    using Clock     = std::chrono::steady_clock;
    double shortest = 1e300;
    for (double spent = 0.; spent < enough_seconds;)
      {
        const auto begin = Clock::now();
        action();
        const std::chrono::duration<double> time = Clock::now() - begin;
        shortest = std::min(shortest, time.count());
        spent += time.count();
      }
    return shortest;
  }



  /**
   * Operations per second of products of matrices of @p n rows, which fit into
   * the cache: of @p n_products in a row, so that the clock can tell their
   * time.
   */
  template <typename Matrix>
  double
  rate(const unsigned int n, const unsigned int n_products)
  {
    const Matrix a = Matrix::Random(n, n), b = Matrix::Random(n, n);
    Matrix       c    = Matrix::Zero(n, n);
    const double time = shortest([&] {
      for (unsigned int i = 0; i < n_products; ++i)
        c.noalias() += a * b;
    });
    return 2. * n * n * n * n_products / time;
  }



  /**
   * Operations of a director element: each addition, each multiplication and
   * each division counts as one, and structural zeros of the gradients are not
   * computed with. Per point: d+1 nodes, 15 fields, 12 strains.
   */
  double
  director_operations(const unsigned int degree)
  {
    const double n_nodes = degree + 1, n_unknowns = 9. * n_nodes;

    // Each of the 5 vectors that is a product of factor and block; the law:
    // a diagonal, and 4 products that couple 3 of the strains.
    const double interpolation = n_nodes * 15 * 2, strains = 12 * 5 + 12 + 10,
                 law = 12 + 10;

    // Nonzeros of the gradients of the 12 strains: 3 of a square, 6 of a
    // product, 12 of the two that are sums of two products.
    const double nonzeros = 3 * 3 + 7 * 6 + 2 * 12;
    const double residual = 2 * nonzeros + 12 + n_nodes * (3 * 2 + 6 * 4);
    const double energy   = 12 * 3;

    // C B, then the lower half of B^T (C B), where row r of B^T has as many
    // nonzeros as its field has strains; half of the geometric terms; fields
    // to unknowns from the right and, the lower half only, from the left.
    const double hessian = 15 * (12 + 10) + 2 * nonzeros * 15 / 2 + 12 * 3;
    const double condensed =
      15 * n_nodes * (3 + 6 * 3) + n_nodes * (3 * 2 + 6 * 4) * n_unknowns / 2;
    return degree * (interpolation + strains + law + residual + energy +
                     hessian + condensed);
  }



  /**
   * The same of the slender element, whose fibers are straight when free: three
   * points with the axial strain, two with the curvature, of which each is a
   * vector that is a combination of four blocks.
   */
  double
  hermite_operations()
  {
    const double vector = 3 * 4 * 2, residual = 3 + 4 * 3 * 2;

    // The dyad of the vector, and it, ten times by products of factors, added
    // to the lower half of the tangent.
    const double tangent = 6 * 2 + 10 * (1 + 9 * 2);
    return 3 * (vector + 6 + 4 + residual + tangent) +
           2 * (vector + 6 + 4 + residual + tangent);
  }



  void
  measure(const std::string &kind,
          const unsigned int degree,
          const double       large,
          const double       small)
  {
    Simulation::FiberParameters parameters("/" + kind + std::to_string(degree));
    parameters.element_kind = choice<Beam::ElementKind>(kind);
    parameters.degree       = degree;

    std::vector<Textile::FiberPath> paths;
    const double                    radius = 0.0045, length = 1.5;
    for (unsigned int f = 0; f < n_fibers; ++f)
      {
        Textile::FiberPath path;
        for (unsigned int i = 0; i <= n_elements; ++i)
          path.points.push_back(
            Tensor<1, 3>({length * i / n_elements, 2. * radius * f, 0.}));
        path.reference_length = length;
        path.radius           = radius;
        paths.push_back(path);
      }
    const auto space =
      Simulation::make_space(paths, parameters, MPI_COMM_WORLD);
    System::State state(*space);
    state.set(Simulation::place_on_paths(*space, paths));
    Contributions::FiberElasticity elasticity(*space, state.current());

    std::mt19937                           generator(1);
    std::uniform_real_distribution<double> uniform(-1e-3, 1e-3);
    System::Increment                      disturbance(state.n_local_blocks());
    for (Tensor<1, 3> &block : disturbance)
      for (unsigned int d = 0; d < 3; ++d)
        block[d] = radius * uniform(generator);
    state.move(1., disturbance);

    System::BlockSystem  system(state, /*symmetric=*/true);
    System::BlockPattern pattern(state.n_owned_blocks());
    elasticity.add_pattern(state, pattern);
    system.set_pattern(pattern);
    const double n = double(n_fibers) * space->fiber(0).n_elements;

    // Zeros are what every contribution shares; the rest is this one's.
    using Want          = System::BlockSystem::Want;
    const double zeros  = shortest([&] {
      system.begin(Want::residual_and_tangent);
      system.end();
    });
    const double all    = shortest([&] {
      system.begin(Want::residual_and_tangent);
      elasticity.assemble(state, system);
      system.end();
    });
    const double forces = shortest([&] {
      system.begin(Want::residual);
      elasticity.assemble(state, system);
    });

    // The elements by themselves, which read no matrix and write none.
    const Beam::Element &element = space->element();
    std::vector<double>  residual(3 * element.n_blocks()),
      tangent(residual.size() * residual.size()),
      reference(element.n_strains());
    const double alone = shortest([&] {
      for (unsigned int f = 0; f < n_fibers; ++f)
        for (unsigned int e = 0; e < space->fiber(f).n_elements; ++e)
          element.assemble(space->fiber(f).section,
                           state.current().data() + state.local_block(f) +
                             space->first_block_of_element(e),
                           space->element_length(f, e),
                           reference.data(),
                           reference.data(),
                           residual.data(),
                           tangent.data());
    });
    const double operations =
      n *
      (kind == "director" ? director_operations(degree) : hermite_operations());
    const double time = all - zeros;
    std::printf(
      "| %s %u | %.0f | %.2f | %.2f | %.2f | %.2f | %.1f | %.1f | %.1f "
      "| %.1f |\n",
      kind.c_str(),
      degree,
      operations / n,
      1e6 * forces / n,
      1e6 * time / n,
      1e6 * alone / n,
      1e6 * zeros / n,
      1e-9 * operations / time,
      time * large / operations,
      time * small / operations,
      alone * small / operations);
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // An element with two nodes of three blocks has a tangent of 18 rows.
  constexpr unsigned int element_size = 18;
  const double           large        = rate<Eigen::MatrixXd>(192, 1),
               small = rate<Eigen::Matrix<double, element_size, element_size>>(
                 element_size, 1000);
  std::printf("Products of matrices: %.1f Gflop/s with 192 rows, %.1f with %u, "
              "as many as the tangent of a director element of degree 1.\n\n"
              "| element | operations | residual [us] | with tangent [us] "
              "| the element alone [us] | zeros of the system [us] | Gflop/s "
              "| times as long as in large products | in small ones "
              "| the element alone |\n"
              "|---|---|---|---|---|---|---|---|---|---|\n",
              1e-9 * large,
              1e-9 * small,
              element_size);
  measure("hermite", 3, large, small);
  for (const unsigned int degree : {1, 2, 3})
    measure("director", degree, large, small);
}
