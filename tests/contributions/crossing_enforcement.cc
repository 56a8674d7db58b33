// The forces of enforced crossings are the derivative of their energy in random
// configurations: central differences approach them with the order two. The
// tangent is the derivative of the forces for motion along z, and the slope and
// curvature that the line search is told are those of forces and tangent.
#include <heddle/base/choice.h>
#include <heddle/contributions/crossing_enforcement.h>
#include <heddle/simulation/fiber_placement.h>

#include "../tests.h"

#include <cmath>
#include <random>

using namespace Heddle;
using Blocks = std::vector<Tensor<1, 3>>;

constexpr unsigned int n_in_yarn = 3;
constexpr double       radius    = 0.1;
constexpr double       length    = 2.;

/** Two straight yarns through each other, yarn 0 along x, yarn 1 along y. */
std::vector<Textile::FiberPath>
make_paths(const unsigned int n_intervals)
{
  std::vector<Textile::FiberPath> paths(2 * n_in_yarn);
  for (unsigned int f = 0; f < paths.size(); ++f)
    {
      paths[f].radius           = radius;
      paths[f].yarn_id          = f / n_in_yarn;
      paths[f].reference_length = length;
      for (unsigned int i = 0; i <= n_intervals; ++i)
        {
          const double along  = length * (double(i) / n_intervals - 0.5);
          const double across = 2. * radius * (f % n_in_yarn);
          paths[f].points.push_back(f < n_in_yarn
                                      ? Tensor<1, 3>({along, across, 0.})
                                      : Tensor<1, 3>({across, along, 0.}));
        }
    }
  return paths;
}



/** Fibers in a random configuration with enforced crossings. */
struct Scene
{
  Scene(const Simulation::FiberParameters &fiber, const unsigned int seed)
    : generator(seed)
    , paths(make_paths(8))
    , space(Simulation::make_space(paths, fiber, MPI_COMM_WORLD))
    , state(*space)
    , system(state)
    , enforcement(*space, {{1, 0}})
  {
    blocks             = Simulation::place_on_paths(*space, paths);
    const Blocks noise = random_motion(/*size=*/0.3 * radius);
    for (unsigned int b = 0; b < blocks.size(); ++b)
      blocks[b] += noise[b];
    enforcement.set_allowance(0.5 * radius);
    move(noise, 0.);
    enforcement.begin_step(state);
    move(noise, 0.);
  }

  Blocks
  random_motion(const double size)
  {
    std::uniform_real_distribution<double> uniform(-size, size);
    Blocks                                 motion(state.n_owned_blocks());
    for (Tensor<1, 3> &vector : motion)
      for (unsigned int d = 0; d < 3; ++d)
        vector[d] = uniform(generator);
    return motion;
  }

  void
  move(const Blocks &direction, const double step)
  {
    Blocks moved = blocks;
    for (unsigned int b = 0; b < moved.size(); ++b)
      moved[b] += step * direction[b];
    state.set(moved);
    enforcement.update(state);
  }

  double
  reported(const std::string &name) const
  {
    std::map<std::string, double> values;
    enforcement.report(state, values);
    return values[name];
  }

  double
  n_active() const
  {
    return reported("enforced_crossings[-]");
  }

  double
  energy(const Blocks &direction, const double step)
  {
    move(direction, step);
    return reported("enforcement_energy[N*mm]");
  }

  double
  slope(const Blocks &direction, const double step)
  {
    move(direction, step);
    return enforcement.slope_and_curvature(state, direction).first;
  }

  /** Products of the assembled forces and of the tangent with @p direction. */
  std::pair<double, double>
  assembled(const Blocks &direction)
  {
    move(direction, 0.);
    System::BlockPattern pattern(state.n_owned_blocks());
    enforcement.add_pattern(state, pattern);
    system.set_pattern(pattern);
    system.set_constraints({});
    system.begin(System::BlockSystem::Want::residual_and_tangent);
    enforcement.assemble(state, system);
    system.end();

    std::pair<double, double> result;
    PetscScalar              *values;
    VecGetArray(system.solution(), &values);
    for (unsigned int b = 0; b < direction.size(); ++b)
      {
        result.first += system.residual()[b] * direction[b];
        for (unsigned int d = 0; d < 3; ++d)
          values[3 * b + d] = direction[b][d];
      }
    VecRestoreArray(system.solution(), &values);
    MatMult(system.tangent(), system.solution(), system.right_hand_side());
    VecDot(system.solution(), system.right_hand_side(), &result.second);
    return result;
  }

  std::mt19937                        generator;
  std::vector<Textile::FiberPath>     paths;
  std::unique_ptr<System::FiberSpace> space;
  System::State                       state;
  System::BlockSystem                 system;
  Contributions::CrossingEnforcement  enforcement;
  Blocks                              blocks;
};



/** Order with which the differences of @p f approach @p derivative. */
template <typename Function>
double
order(const Function &f, const double derivative)
{
  const auto error = [&](const double h) {
    return std::abs((f(h) - f(-h)) / (2. * h) - derivative);
  };
  return std::round(10. * std::log2(error(5e-3 * radius) / //
                                    error(2.5e-3 * radius))) /
         10.;
}



void
check(const Simulation::FiberParameters &fiber, const unsigned int seed)
{
  Scene        scene(fiber, seed);
  const Blocks any = scene.random_motion(1.);
  Blocks       up  = any;
  for (Tensor<1, 3> &vector : up)
    vector[0] = vector[1] = 0.;

  const auto assembled = scene.assembled(any);
  const auto told = scene.enforcement.slope_and_curvature(scene.state, any);
  deallog << word(fiber.element_kind) << " " << seed << ": active "
          << static_cast<unsigned int>(scene.n_active())
          << ", order of the forces "
          << order([&](const double h) { return scene.energy(any, h); },
                   assembled.first);

  // Along z the gap is linear, and so is the force beyond the first part of the
  // law: the differences are exact.
  const double h = 1e-2 * radius;
  const double curvature =
    (scene.slope(up, h) - scene.slope(up, -h)) / (2. * h);
  deallog << ", tangent along z "
          << (std::abs(scene.assembled(up).second / curvature - 1.) < 1e-8)
          << ", slope " << (std::abs(told.first / assembled.first - 1.) < 1e-10)
          << ", curvature "
          << (std::abs(told.second / assembled.second - 1.) < 1e-10)
          << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest                     test(argc, argv);
  Simulation::FiberParameters fiber;
  for (const std::string name : {"hermite", "director"})
    for (unsigned int seed = 1; seed <= 3; ++seed)
      {
        fiber.element_kind = choice<Beam::ElementKind>(name);
        check(fiber, seed);
      }
}
