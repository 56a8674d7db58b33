// Plates that press on fibers: the residual is the derivative of the energy and
// the tangent that of the residual, to the order of the differences; what is
// said along a motion is the same, and nothing is pushed along the plates.
// Penalties grow with the penetration, but not without end, and are taken back
// with a step. Plates that do not cover all of a fiber leave the rest alone.
// Wild guesses are not followed. Plates that have parted from a fiber are no
// nonsmooth term, and it gets no further than into their reach unseen.
#include <heddle/contributions/plates.h>

#include "../contact/contact_scene.h"
#include "../tests.h"

using Heddle::Contributions::Plates;
using Heddle::System::BlockSystem;
using Motion = std::vector<Tensor<1, 3>>;

constexpr unsigned int n_intervals = 12;

/** Plates that come nearer to each other by this formula. */
const Heddle::Contributions::PlateParameters &
pressed_by(const std::string &compression)
{
  static Heddle::Contributions::PlateParameters parameters;
  parameters.compression = compression;
  return parameters;
}



/** Two wavy fibers at an angle, on random paths. */
ContactScene
wavy_fibers(const std::string &element, RandomNumbers &random)
{
  ContactScene::Options options;
  options.element = element;
  const Tensor<1, 3> x({1., 0., 0.}), y({0.3, 1., 0.});
  return {{wavy_line(-20. * x, x, 40., 2., random),
           wavy_line(-20. * y, y / y.norm(), 40., 2., random)},
          {n_intervals, n_intervals},
          options};
}



double
dot(const Motion &a, const Motion &b)
{
  double sum = 0.;
  for (unsigned int i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}



class Press
{
public:
  Press(ContactScene &scene, Plates &plates)
    : scene(scene)
    , plates(plates)
    , start(scene.state.current())
  {
  }

  /** Move to so many times @p motion from the start. */
  void
  go(const double scale, const Motion &motion)
  {
    Motion moved = start;
    for (unsigned int b = 0; b < start.size(); ++b)
      moved[b] += scale * motion[b];
    scene.state.set(moved);
    plates.update(scene.state);
  }

  double
  energy() const
  {
    std::map<std::string, double> values;
    plates.report(scene.state, values);
    return values.at("plate_energy[N*mm]");
  }

  Motion
  residual()
  {
    BlockSystem system(scene.state);
    system.begin(BlockSystem::Want::residual);
    plates.assemble(scene.state, system);
    return system.residual();
  }

  Motion
  tangent_times(const Motion &motion)
  {
    BlockSystem                  system(scene.state);
    Heddle::System::BlockPattern pattern(scene.state.n_owned_blocks());
    plates.add_pattern(scene.state, pattern);
    system.set_pattern(pattern);
    system.set_constraints({});
    system.begin(BlockSystem::Want::residual_and_tangent);
    plates.assemble(scene.state, system);
    system.end();
    return ContactScene::times(system, motion);
  }

private:
  ContactScene &scene;
  Plates       &plates;
  const Motion  start;
};



/** What differences of a step miss, summed up over many states. */
struct Errors
{
  double energy = 0., residual = 0.;
};



/**
 * Errors of many states. The law is quadratic where points begin to touch, and
 * then linear: of their force that leaves the kinks of those that pass from one
 * to the other within a step. There are as many as the step is long, each errs
 * by as much as that, and by chance up or down: of order 1.5 in all.
 */
void
derivatives()
{
  const std::array<double, 3> steps = {{4e-3, 2e-3, 1e-3}};
  for (const std::string element : {"hermite", "director"})
    {
      std::array<Errors, 3> errors;
      double                along = 0., across = 0.;
      for (unsigned int seed = 0; seed < 100; ++seed)
        {
          RandomNumbers random(seed);
          ContactScene  scene = wavy_fibers(element, random);
          Plates        plates(scene.space, pressed_by("0.3*t"), 0.05, {});
          plates.begin_stage(scene.state);
          scene.state.load_factor = 1.;
          Press  press(scene, plates);
          Motion motion(scene.state.current().size());
          for (Tensor<1, 3> &block : motion)
            block = random.direction();

          press.go(0., motion);
          const Motion residual = press.residual();
          const Motion tangent  = press.tangent_times(motion);
          const double slope    = dot(residual, motion);
          const auto   said = plates.slope_and_curvature(scene.state, motion);
          along             = std::max({along,
                                        std::abs(said.first / slope - 1.),
                                        std::abs(said.second / dot(tangent, motion) - 1.)});
          for (const Tensor<1, 3> &force : residual)
            across = std::max({across, std::abs(force[0]), std::abs(force[1])});
          for (unsigned int k = 0; k < steps.size(); ++k)
            {
              const double h = steps[k];
              press.go(h, motion);
              const double energy_after   = press.energy();
              const Motion residual_after = press.residual();
              press.go(-h, motion);
              const double energy_before   = press.energy();
              const Motion residual_before = press.residual();
              errors[k].energy +=
                std::abs((energy_after - energy_before) / (2. * h) - slope);
              double sum = 0.;
              for (unsigned int b = 0; b < tangent.size(); ++b)
                sum += ((residual_after[b] - residual_before[b]) / (2. * h) -
                        tangent[b])
                         .norm_square();
              errors[k].residual += std::sqrt(sum);
            }
        }
      const auto order = [](const double coarse, const double fine) {
        std::cout << "observed order " << std::log2(coarse / fine) << std::endl;
        return std::round(2. * std::log2(coarse / fine)) / 2.;
      };
      deallog << element << ": gradient of order "
              << order(errors[0].energy, errors[1].energy) << ", "
              << order(errors[1].energy, errors[2].energy)
              << ", tangent of order "
              << order(errors[0].residual, errors[1].residual) << ", "
              << order(errors[1].residual, errors[2].residual)
              << ", along a motion " << (along < 1e-10 ? "the same" : "ANOTHER")
              << ", across " << across << std::endl;
    }
}



/** A level fiber of length 40, and plates as deep in it as they are asked to.
 */
class LevelFiber
{
public:
  LevelFiber(const std::optional<BoundingBox<2>> &covered = {})
    : scene(
        {line(Tensor<1, 3>({-20., 0., 0.}), Tensor<1, 3>({1., 0., 0.}), 40.)},
        {n_intervals})
    , plates(scene.space, pressed_by("t"), threshold, covered)
  {
    plates.begin_stage(scene.state);
  }

  /** The distance of the plates is 2 at first. */
  double
  force(const double penetration)
  {
    scene.state.load_factor = penetration;
    plates.update(scene.state);
    plates.accept_step(scene.state);
    return reported("plate_force[N]");
  }

  double
  reported(const std::string &name) const
  {
    std::map<std::string, double> values;
    plates.report(scene.state, values);
    return values.at(name);
  }

  static constexpr double threshold = 0.02;

  ContactScene scene;
  Plates       plates;
};



/**
 * All of a level fiber is as deep in both plates, so that its force is length
 * times penalty times (d - d_0 / 2) with the first penalty E pi / 20 and
 * d_0 = 0.01.
 */
void
penalties()
{
  LevelFiber   fiber;
  const double first = 40. * numbers::PI / 4.;
  deallog << "force of the first penalty over the expected one "
          << fiber.force(0.03) / (first * 0.025) << std::endl;

  // Aims at three quarters of the threshold.
  fiber.plates.update(fiber.scene.state);
  fiber.plates.set_softness(0.5);
  deallog << "by soft fibers raised " << fiber.plates.adapt(fiber.scene.state)
          << std::endl;
  fiber.plates.set_softness(0.);
  const bool raised = fiber.plates.adapt(fiber.scene.state);
  fiber.plates.update(fiber.scene.state);
  fiber.plates.reject_step(fiber.scene.state);
  deallog << "raised " << raised << ", and after a rejected step "
          << fiber.force(0.03) / (first * 0.025) << std::endl;
  fiber.plates.adapt(fiber.scene.state);
  const double grown = fiber.force(0.03) / (first * 0.025);
  deallog << "grown to " << grown << ", for a penetration of "
          << 0.03 / fiber.threshold
          << " thresholds: " << fiber.plates.objection(fiber.scene.state)
          << std::endl;
  unsigned int rounds = 1;
  while (fiber.plates.adapt(fiber.scene.state))
    ++rounds;
  deallog << "after " << rounds << " rounds "
          << fiber.force(0.03) / (first * 0.025) << std::endl;
  fiber.force(0.019);
  deallog << "less deep: \"" << fiber.plates.objection(fiber.scene.state)
          << "\", raised " << fiber.plates.adapt(fiber.scene.state)
          << std::endl;
}



/** All or half of the fiber is covered; work and energy of a step from nothing.
 */
void
covered()
{
  const BoundingBox<2> half({Point<2>(-15., -5.), Point<2>(5., 5.)});
  for (const auto &plate :
       {std::optional<BoundingBox<2>>(), std::optional<BoundingBox<2>>(half)})
    {
      LevelFiber   fiber(plate);
      const double force = fiber.force(0.1);
      deallog << (plate ? "half" : "all") << ": force over length "
              << force / 40. << ", distance "
              << fiber.reported("plate_distance[mm]") << ", work "
              << fiber.reported("external_work[N*mm]") / force
              << " times force";
      std::map<std::string, double> values;
      fiber.plates.report(fiber.scene.state, values);
      if (values.count("plate_pressure[MPa]") > 0)
        deallog << ", pressure over force "
                << values.at("plate_pressure[MPa]") / force;
      deallog << std::endl;
    }
}



/** A guess is not followed if it is deep in a plate, or far from both. */
void
guesses()
{
  LevelFiber fiber;
  fiber.force(0.1);
  for (const double penetration : {0.1, 0.2, 0.35, 0., 0.09})
    {
      fiber.scene.state.load_factor = penetration;
      fiber.plates.update(fiber.scene.state);
      deallog << penetration << " deep: "
              << (fiber.plates.is_credible() ? "followed" : "not followed")
              << std::endl;
    }
}



/**
 * Plates at a distance of 0.1, 0.2 and 0.5 radii from a level fiber: a step
 * that lifts it ends at 0.15 radii from the upper one, and sooner where it
 * makes a wave between two nodes. An end that is not covered goes where it
 * likes.
 */
void
reach()
{
  LevelFiber fiber(BoundingBox<2>({Point<2>(-15., -5.), Point<2>(5., 5.)}));
  auto      &state = fiber.scene.state;
  Motion     lifted(state.current().size());
  for (unsigned int i = 0; i <= n_intervals; ++i)
    lifted[2 * i][2] = 1.;
  Motion end_lifted(state.current().size());
  end_lifted[2 * n_intervals][2] = 100.;
  Motion turned                  = lifted;
  // Control points lie above the nodes by the slope times a third of h.
  const double h       = 40. / n_intervals;
  turned[2 * 6 + 1][2] = 0.1;
  turned[2 * 7 + 1][2] = -0.1;
  for (const double distance : {0.1, 0.2, 0.5})
    {
      state.load_factor = -distance;
      fiber.plates.update(state);
      deallog << distance << " away: nonsmooth " << fiber.plates.is_nonsmooth();
      if (!fiber.plates.is_nonsmooth())
        deallog << ", lifted by " << fiber.plates.searched_step(state, lifted)
                << ", in a wave by "
                << fiber.plates.searched_step(state, turned) *
                     (1. + 0.1 * h / 3.)
                << ", its end alone by more than 1: "
                << (fiber.plates.searched_step(state, end_lifted) > 1.);
      deallog << std::endl;
    }
}



int
main(int argc, char **argv)
{
  const MPITest mpi(argc, argv);
  run_part("Derivatives", derivatives);
  run_part("Penalties", penalties);
  run_part("Covered parts", covered);
  run_part("Guesses", guesses);
  run_part("Reach", reach);
}
