// A spring is pulled against more and more walls, as a step closes contacts.
// The search ends where the slope is a fifth of the first one or less, and
// tries fewer places on the way than if it went by chords or halved the
// interval. What a little prescribed motion raises on the way belongs to the
// step, and does not shorten it; where there is much of it forces do not drive
// the step.
#include <heddle/beam/element.h>
#include <heddle/solver/line_search.h>

#include "../tests.h"

#include <algorithm>
#include <array>
#include <functional>
#include <random>

using namespace Heddle;

constexpr double force = 1., stiffness = 1., end = force / stiffness;
constexpr double flat = 0.2;



/** Pulls block 0 along x; the other blocks are held by springs. */
class Spring : public System::Contribution
{
public:
  std::string
  name() const override
  {
    return "spring";
  }

  void
  assemble(const System::State &state, System::BlockSystem &system) override
  {
    for (unsigned int b = 0; b < state.n_owned_blocks(); ++b)
      system.add_diagonal(b, stiffness);
    system.add_force(0, Tensor<1, 3>({-force, 0., 0.}));
  }
};



/** Ties block 1 to block 0 as well. */
class Tie : public System::Contribution
{
public:
  std::string
  name() const override
  {
    return "tie";
  }

  void
  add_pattern(const System::State &, System::BlockPattern &pattern) override
  {
    pattern.couple(2, blocks.data());
  }

  void
  assemble(const System::State &, System::BlockSystem &system) override
  {
    std::array<double, 6>  residual = {};
    std::array<double, 36> tangent  = {};
    tangent[3] = tangent[18] = stiffness;
    system.add(2, blocks.data(), residual.data(), tangent.data());
  }

private:
  const std::array<unsigned int, 2> blocks = {{0, 1}};
};



/** Presses block 0 back, the more the further it comes. */
class Walls : public System::NonsmoothContribution
{
public:
  std::string
  name() const override
  {
    return "walls";
  }

  void
  update(System::State &) override
  {
  }

  void
  update_trial(System::State &) override
  {
    ++n_places;
  }

  void
  assemble(const System::State &, System::BlockSystem &) override
  {
  }

  /** Force at the place @p x, and its derivative. */
  std::pair<double, double>
  at(const double x) const
  {
    std::pair<double, double> sum = {0., 0.};
    for (const auto &wall : walls)
      if (x > wall.first)
        {
          sum.first += wall.second * (x - wall.first);
          sum.second += wall.second;
        }
    return sum;
  }

  std::pair<double, double>
  slope_and_curvature(const System::State     &state,
                      const System::Increment &increment) const override
  {
    const double u    = increment[0][0];
    const auto   push = at(state.current()[0][0]);
    return {push.first * u, push.second * u * u};
  }

  std::vector<std::pair<double, double>> walls; /**< places, stiffnesses */
  unsigned int                           n_places = 0;
};



/** Slope of the energy after a part of the step over the first one. */
double
slope(const Walls &walls, const double part)
{
  return (-force + stiffness * part * end + walls.at(part * end).first) / force;
}



/** Places that are tried if an interval is divided at @p divide(low, high). */
unsigned int
n_places(const Walls                                             &walls,
         const std::function<double(const double, const double)> &divide)
{
  double       low = 0., high = 1.;
  unsigned int n = 1;
  for (; n <= 6 && slope(walls, high) > flat; ++n)
    {
      const double size = high - low;
      const double next =
        std::clamp(divide(low, high), low + 0.1 * size, low + 0.9 * size);
      if (slope(walls, next) < -flat)
        low = next;
      else
        high = next;
    }
  return n;
}



/**
 * Whether forces drive the step, and how much of it a search takes without
 * walls, if block 1 still has to move by @p pending.
 */
void
examine_raised(System::State &state, const double pending)
{
  Solver::Contributions contributions = {std::make_shared<Spring>(),
                                         std::make_shared<Tie>()};
  System::BlockSystem   system(state);
  System::BlockPattern  pattern(state.n_owned_blocks());
  contributions[1]->add_pattern(state, pattern);
  system.set_pattern(pattern);
  System::Constraint constraint = {};
  constraint.block              = 1;
  constraint.fixed              = {{true, true, true}};
  constraint.frame              = unit_symmetric_tensor<3>();
  constraint.pending            = {{pending, 0., 0.}};
  system.set_constraints({constraint});
  system.begin(System::BlockSystem::Want::residual_and_tangent);
  for (const auto &contribution : contributions)
    contribution->assemble(state, system);
  system.end();

  VecSet(system.solution(), 0.);
  VecSetValue(system.solution(),
              0,
              (force - stiffness * pending) / stiffness,
              INSERT_VALUES);
  VecAssemblyBegin(system.solution());
  VecAssemblyEnd(system.solution());
  System::Increment increment;
  system.extract_increment(increment);
  const auto         terms = Solver::nonsmooth_terms(contributions);
  Solver::LineSearch along(state, terms, system, increment, 0.);
  deallog << "prescribed, over what forces do: " << pending * stiffness / force
          << ", driven by forces: "
          << Solver::LineSearch::driven_by_forces(system, increment)
          << ", step " << along.best_step(/*longest=*/1.) << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest                         test(argc, argv);
  System::FiberSpace::Description fiber = {};
  fiber.element_lengths                 = {1.};
  fiber.radius                          = 0.1;
  fiber.section =
    Beam::circular_section(0.1, /*axial=*/1., /*shear=*/0.4, /*poisson=*/0.25);
  const System::FiberSpace space(
    MPI_COMM_WORLD,
    Beam::make_element(Beam::ElementKind::hermite, /*degree=*/3),
    {fiber});
  System::State state(space);

  const auto                  walls         = std::make_shared<Walls>();
  const Solver::Contributions contributions = {std::make_shared<Spring>(),
                                               walls};
  System::BlockSystem         system(state);
  system.set_pattern(System::BlockPattern(state.n_owned_blocks()));
  system.set_constraints({});
  system.begin(System::BlockSystem::Want::residual_and_tangent);
  for (const auto &contribution : contributions)
    contribution->assemble(state, system);
  system.end();
  System::Increment increment(state.n_local_blocks());
  increment[0][0] = end;
  VecSet(system.solution(), 0.);
  VecSetValue(system.solution(), 0, end, INSERT_VALUES);
  VecAssemblyBegin(system.solution());
  VecAssemblyEnd(system.solution());

  std::mt19937                           generator(1);
  std::uniform_real_distribution<double> random(0., 1.);
  const unsigned int                     n_searches = 300;
  unsigned int by_search = 0, by_chords = 0, by_halves = 0, n_steep = 0;
  for (unsigned int search = 0; search < n_searches; ++search)
    {
      // Together one to a thousand times as stiff as the spring.
      const unsigned int n    = 1 + 40 * random(generator);
      const double       hard = std::pow(10., 3. * random(generator));
      walls->walls.clear();
      for (unsigned int i = 0; i < n; ++i)
        walls->walls.emplace_back(end * random(generator), hard / n);
      walls->n_places          = 0;
      const auto         terms = Solver::nonsmooth_terms(contributions);
      Solver::LineSearch along(state, terms, system, increment, 0.);
      const double       step = along.best_step(/*longest=*/1.);
      n_steep += std::abs(slope(*walls, step)) > flat ? 1 : 0;
      by_search += walls->n_places;
      by_halves += n_places(*walls, [](const double low, const double high) {
        return 0.5 * (low + high);
      });
      by_chords += n_places(*walls, [&](const double low, const double high) {
        const double a = slope(*walls, low), b = slope(*walls, high);
        return low + (high - low) * a / (a - b);
      });
    }
  // 5 in 300 are given up before; 950, 1186 and 1405 places.
  deallog
    << "searches that end where the slope is steeper, one in fifty or less: "
    << (50 * n_steep <= n_searches) << std::endl
    << "places below 0.85 of those by chords: "
    << (by_search < 0.85 * by_chords)
    << ", below 0.75 of those by halves: " << (by_search < 0.75 * by_halves)
    << std::endl;
  for (const double pending : {0., 0.4, -0.4, 0.6, -0.6})
    examine_raised(state, pending);
}
