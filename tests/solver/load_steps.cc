// Load steps: how long they are, where they have to end, and what is guessed of
// the equilibrium there.
#include <heddle/beam/element.h>
#include <heddle/simulation/fabric_loading_parameters.h>
#include <heddle/solver/load_stepping.h>
#include <heddle/solver/predictor.h>
#include <heddle/system/state.h>

#include "../tests.h"

#include <cmath>

using Heddle::System::FiberSpace;
using Heddle::System::State;

/** Newton iterations of each attempt; 0: it failed. */
void
attempt(Heddle::Solver::LoadStepping    &stepping,
        const std::vector<unsigned int> &attempts)
{
  for (const unsigned int iterations : attempts)
    {
      deallog << stepping.reached() << " -> " << stepping.next();
      if (iterations > 0)
        stepping.accept(iterations);
      else
        deallog << " failed, shorter " << stepping.cut_back();
      deallog << std::endl;
    }
}



/**
 * Load steps hit the points that are asked for, grow after easy steps, are
 * halved after failures, and are given up when they would get too short.
 */
void
lengths()
{
  Heddle::Solver::LoadPlan plan;
  plan.initial_step  = 0.1;
  plan.largest_step  = 0.3;
  plan.smallest_step = 0.02;
  plan.points        = {0.25};
  Heddle::Solver::LoadStepping stepping(plan);

  attempt(stepping, {5, 5, 20, 5, 0, 0, 5, 5, 5});
  while (!stepping.finished())
    stepping.accept(5);
  deallog << "finished at " << stepping.reached() << std::endl;

  // After a cut hard steps grow again, but less soon if they fail again.
  plan.points = {};
  Heddle::Solver::LoadStepping hard(plan);
  attempt(hard, {20, 0, 20, 20, 20, 20, 0, 20, 20, 20, 20, 20, 20, 20});

  // A step to 0 comes first, is not halved, and leaves the others as they were.
  Heddle::Solver::LoadStepping from_zero(plan);
  from_zero.begin_at_zero();
  deallog << "has begun " << from_zero.has_begun() << std::endl;
  attempt(from_zero, {0, 5});
  deallog << "has begun " << from_zero.has_begun() << std::endl;
  attempt(from_zero, {5, 5});

  Heddle::Solver::LoadStepping stubborn(plan);
  while (stubborn.cut_back())
    deallog << "halved to " << stubborn.next() << std::endl;
  deallog << "given up at " << stubborn.reached() << std::endl;
}



void
turn_back(const std::string &ramp)
{
  Heddle::Simulation::FabricLoadingParameters loading("/Of " + ramp);
  ParameterAcceptor::initialize();
  ParameterAcceptor::prm.enter_subsection("Of " + ramp);
  ParameterAcceptor::prm.set("Ramp", ramp);
  ParameterAcceptor::prm.leave_subsection();
  ParameterAcceptor::parse_all_parameters();
  Heddle::Solver::LoadPlan plan;
  plan.initial_step = 0.1;
  plan.points       = {0.25, 0.5};
  plan.reach(loading.turning_points());
  deallog << ramp << ": turns at";
  for (const double point : loading.turning_points())
    deallog << ' ' << point;
  deallog << "; steps hit";
  for (const double point : plan.points)
    deallog << ' ' << point;
  deallog << std::endl;
}



/**
 * Load steps hit the places at which the ramp of a fabric's test turns back,
 * with a kink or without or after it has stayed, and none where it goes on;
 * beside the points that were asked for.
 */
void
turning_points()
{
  deallog << std::setprecision(7);
  turn_back("t");
  turn_back("1 - abs(2*t - 1)");
  turn_back("1 - abs(t - 0.3337) - 0.6663");
  turn_back("sin(3*pi*t)");
  turn_back("min(2*t, 1)");
  turn_back("min(2*t, 1) - max(0, 4*t - 3)");
  turn_back("min(1, min(2.5*t, 2*(1-t)))");
  turn_back("min(2*t, 1) + max(0, t - 0.75)");
  turn_back("abs(abs(4*t - 2) - 1) - 1");
}



/** Where paths jump that do. */
constexpr double jump_at = 0.12;

/** How far the motion goes, and a section turns [rad], at load factor t. */
struct Path
{
  double linear, square, cubic, jump = 0.;

  double
  operator()(const double t) const
  {
    return linear * t + square * t * t + cubic * t * t * t +
           (t > jump_at ? jump : 0.);
  }
};



/** Put the nodes, and the sections of lengths 0.9 and 1.1, where @p path is. */
void
place(State &state, const Path &path, const double load_factor)
{
  const double              way = path(load_factor);
  const Tensor<1, 3>        direction({1., -2., 0.5});
  std::vector<Tensor<1, 3>> blocks(state.n_local_blocks());
  for (unsigned int b = 0; b < blocks.size(); b += 3)
    {
      const double angle = 0.1 * b + way;
      blocks[b]          = (1. + b) * way * direction;
      blocks[b + 1] = Tensor<1, 3>({0., 0.9 * cos(angle), 0.9 * sin(angle)});
      blocks[b + 2] = Tensor<1, 3>({0., -1.1 * sin(angle), 1.1 * cos(angle)});
    }
  state.set(blocks);
  state.load_factor = load_factor;
}



/**
 * The largest error of the guess after equilibria at @p known load factors, of
 * positions and of section vectors, for the load factor @p next.
 */
std::pair<double, double>
miss(State                     &state,
     const Path                &path,
     const std::vector<double> &known,
     const double               next)
{
  Heddle::Solver::Predictor predictor;
  place(state, path, known.front());
  predictor.begin(state);
  for (unsigned int i = 1; i < known.size(); ++i)
    {
      place(state, path, known[i]);
      predictor.add(state);
    }
  state.load_factor                      = next;
  const Heddle::System::Increment motion = predictor.guess(state);
  if (motion.empty())
    {
      deallog << "nothing is guessed" << std::endl;
      return {0., 0.};
    }
  state.move(1., motion);
  const std::vector<Tensor<1, 3>> guessed = state.current();
  place(state, path, next);
  std::pair<double, double> largest = {0., 0.};
  for (unsigned int b = 0; b < guessed.size(); ++b)
    {
      double &error = b % 3 == 0 ? largest.first : largest.second;
      error         = std::max(error, (guessed[b] - state.current()[b]).norm());
    }
  return largest;
}



void
examine(const std::string &name, const std::pair<double, double> &error)
{
  const auto in_words = [](const double value) {
    return value < 1e-12 ? std::string("none") : std::to_string(value);
  };
  deallog << name << ": error of positions " << in_words(error.first)
          << ", of sections " << in_words(error.second) << std::endl;
}



/**
 * The guess of the next equilibrium: nothing from one equilibrium, the line
 * through two and, once a fourth one has shown it to be the better guess, the
 * parabola through three. It is not after a jump. Sections turn about their
 * axis, with the lengths that they have. What is not a parabola is missed by
 * the third order of the step.
 */
void
guesses()
{
  Heddle::System::FiberSpace::Description fiber;
  fiber.element_lengths.assign(2, 1.);
  fiber.radius  = 1.;
  fiber.section = Heddle::Beam::circular_section(fiber.radius,
                                                 /*axial_modulus=*/1.,
                                                 /*shear_modulus=*/0.5,
                                                 /*poisson_ratio=*/0.);
  const Heddle::System::FiberSpace space(
    MPI_COMM_WORLD,
    Heddle::Beam::make_element(Heddle::Beam::ElementKind::director, 1),
    {fiber});
  State state(space);

  miss(state, {1., 0., 0.}, {0.}, 0.1);
  examine("a line, two equilibria", miss(state, {1., 0., 0.}, {0., 0.1}, 0.3));
  examine("a parabola, steps that differ",
          miss(state, {1., -2., 0.}, {-0.2, 0., 0.1, 0.15}, 0.3));
  examine("the last four of five",
          miss(state, {1., -2., 0.}, {-5., -0.2, 0., 0.1, 0.15}, 0.3));
  examine("a parabola, two equilibria",
          miss(state, {1., -2., 0.}, {0., 0.1}, 0.15));
  examine("a parabola, three equilibria",
          miss(state, {1., -2., 0.}, {-0.2, 0., 0.1}, 0.15));
  const Path jumping = {1., 0., 0., 0.3};
  examine("two equilibria after a jump",
          miss(state, jumping, {0.05, 0.1, 0.15, 0.2}, 0.25));
  examine("three equilibria after a jump",
          miss(state, jumping, {0.1, 0.15, 0.2, 0.25}, 0.3));

  for (const double step : {0.1, 0.05, 0.025})
    {
      const Path   cubic = {2., 1., -0.5};
      const double half  = 0.5 * step;
      const auto   whole =
        miss(state, cubic, {-step, 0., step, 2. * step}, 3. * step);
      const auto finer =
        miss(state, cubic, {-half, 0., half, 2. * half}, 3. * half);
      deallog << "a cubic, order with steps of " << step << ": positions "
              << std::log2(whole.first / finer.first) << ", sections "
              << std::log2(whole.second / finer.second) << std::endl;
    }
}



int
main(int argc, char **argv)
{
  const MPITest mpi(argc, argv);
  run_part("Lengths of steps", lengths);
  run_part("Places at which a ramp turns back", turning_points);
  run_part("Guesses", guesses);
}
