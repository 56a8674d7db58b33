#ifndef heddle_tests_contributions_scene_h
#define heddle_tests_contributions_scene_h

#include <heddle/base/choice.h>
#include <heddle/contributions/fiber_elasticity.h>
#include <heddle/contributions/loads.h>
#include <heddle/contributions/support_parameters.h>
#include <heddle/contributions/supports.h>
#include <heddle/simulation/fiber_placement.h>
#include <heddle/solver/newton.h>

#include "../tests.h"

#include <cmath>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

using namespace Heddle;

/** A straight fiber of @p n_knots equally spaced knots. */
inline Textile::FiberPath
straight_path(const Tensor<1, 3> &begin,
              const Tensor<1, 3> &end,
              const unsigned int  n_knots,
              const double        radius)
{
  Textile::FiberPath path;
  for (unsigned int i = 0; i < n_knots; ++i)
    path.points.push_back(begin + double(i) / (n_knots - 1) * (end - begin));
  path.reference_length = (end - begin).norm();
  path.radius           = radius;
  return path;
}



/** Fibers with supports and loads, and Newton's method for them. */
class Scene
{
public:
  Contributions::Support &
  add_support()
  {
    support_list.push_back(std::make_shared<Contributions::SupportParameters>(
      "/Supports/Support " + std::to_string(support_list.size() + 1)));
    return *support_list.back();
  }

  /** A support that holds the ends @p nodes of @p fibers in every respect. */
  Contributions::Support &
  clamp(const std::string &nodes, const std::string &fibers = "all")
  {
    auto &support        = add_support();
    support.nodes.nodes  = choice<Contributions::ChosenNodes>(nodes);
    support.nodes.fibers = fibers;
    support.displacement = {{"0", "0", "0"}};
    support.section      = Contributions::SupportedSection::held;
    return support;
  }

  Contributions::LoadParameters &
  add_load()
  {
    load_list.push_back(std::make_unique<Contributions::LoadParameters>(
      "/Loads/Load " + std::to_string(load_list.size() + 1)));
    return *load_list.back();
  }

  /** Create all objects; the reference are the @p paths. */
  void
  build(const std::vector<Textile::FiberPath> &paths)
  {
    space = Simulation::make_space(paths, fibers, MPI_COMM_WORLD);
    state = std::make_unique<System::State>(*space);
    const auto reference = Simulation::place_on_paths(*space, paths);
    state->set(reference);
    state->accept();
    contributions.push_back(
      std::make_shared<Contributions::FiberElasticity>(*space, reference));
    contributions.push_back(std::make_shared<Contributions::Supports>(
      *space, reference, support_list));
    contributions.push_back(
      std::make_shared<Contributions::Loads>(*space, reference, load_list));
    solver = std::make_unique<Solver::Newton>(newton, linear, log, timer, stop);
  }

  Solver::NewtonResult
  solve(const double load_factor)
  {
    state->load_factor = load_factor;
    for (const auto &contribution : contributions)
      contribution->begin_step(*state);
    return solver->solve(*state, contributions);
  }

  /** Solve, and keep what was found. */
  Solver::NewtonResult
  step(const double load_factor)
  {
    const auto result = solve(load_factor);
    for (const auto &contribution : contributions)
      contribution->accept_step(*state);
    state->accept();
    return result;
  }

  std::map<std::string, double>
  report() const
  {
    std::map<std::string, double> values;
    for (const auto &contribution : contributions)
      contribution->report(*state, values);
    return values;
  }

  /** Block @p b of node @p node of @p fiber, on all ranks. */
  Tensor<1, 3>
  block(const unsigned int fiber,
        const unsigned int node,
        const unsigned int b = 0) const
  {
    Tensor<1, 3> value;
    if (space->owns(fiber))
      value = state->fiber(fiber)[node * space->n_blocks_per_node() + b];
    return Utilities::MPI::sum(value, MPI_COMM_WORLD);
  }

  unsigned int
  last_node(const unsigned int fiber = 0) const
  {
    return space->fiber(fiber).n_nodes - 1;
  }

  Simulation::FiberParameters         fibers;
  Solver::NewtonParameters            newton;
  Solver::LinearSolverParameters      linear;
  Contributions::SupportList          support_list;
  Contributions::LoadList             load_list;
  std::ostringstream                  screen;
  Log                                 log{MPI_COMM_WORLD, screen};
  SectionTimer                        timer;
  StopRequest                         stop{MPI_COMM_WORLD};
  std::unique_ptr<System::FiberSpace> space;
  std::unique_ptr<System::State>      state;
  Solver::Contributions               contributions;
  std::unique_ptr<Solver::Newton>     solver;
};



/** The word that the reader of a reference looks for. */
inline std::string
verdict(const bool good)
{
  return good ? "" : " FAIL";
}

#endif
