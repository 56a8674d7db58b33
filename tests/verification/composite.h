#ifndef heddle_tests_verification_composite_h
#define heddle_tests_verification_composite_h

#include <heddle/base/choice.h>
#include <heddle/simulation/matrix.h>

#include "../contributions/scene.h"

#include <iomanip>
#include <iostream>

/** Fibers in a block, with Newton's method for both. */
class Composite : public Scene
{
public:
  /** @p entries of the section Matrix, the block's corners among them. */
  Composite(const std::string &entries)
    : parameters("/Matrix " + std::to_string(++n_scenes))
  {
    ParameterAcceptor::prm.parse_input_from_string(
      "subsection Matrix " + std::to_string(n_scenes) +
      "\n set Shape = block\n set Leave out cells inside yarns = false\n"
      " set Lower corner = 0, 0, 0\n" +
      entries + "end\n");
    ParameterAcceptor::parse_all_parameters();

    // What is measured is the composite, to more digits than iterations leave.
    linear.kind = Heddle::Solver::LinearSolverKind::direct;
  }

  void
  embed(const std::vector<Textile::FiberPath> &paths)
  {
    build(paths);
    matrix = std::make_unique<Simulation::Matrix>(
      parameters, *state, /*sections_are_turned=*/false);
    contributions.push_back(matrix->elasticity());
    contributions.push_back(matrix->coupling());
    for (const auto &contribution : contributions)
      contribution->begin_stage(*state);
  }

  /** A support of sides of the matrix alone. */
  Contributions::Support &
  hold(const std::vector<std::string> &sides)
  {
    auto &support        = add_support();
    support.nodes.fibers = "none";
    for (const std::string &side : sides)
      support.matrix_sides.push_back(choice<Contributions::MatrixSide>(side));
    return support;
  }

  std::unique_ptr<Simulation::Matrix> matrix;

private:
  inline static unsigned int   n_scenes = 0;
  Simulation::MatrixParameters parameters;
};



/** Entries for a block from the origin to @p corner [mm]. */
inline std::string
mesh(const unsigned int  n_x,
     const unsigned int  n_yz,
     const Tensor<1, 3> &corner)
{
  std::ostringstream text;
  text << " set Columns x = " << n_x << "\n set Columns y = " << n_yz
       << "\n set Layers = " << n_yz << "\n set Upper corner = " << corner[0]
       << ", " << corner[1] << ", " << corner[2] << "\n";
  return text.str();
}



/** Show a number that is not compared. */
inline void
print(const std::string &what, const double n, const double value)
{
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << what << ", " << n << ": " << std::setprecision(3) << value
              << std::endl;
}

#endif
