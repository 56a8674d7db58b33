// Plates that press on fibers: the residual is the derivative of the energy and
// the tangent that of the residual, to the order of the differences; what is
// said along a motion is the same, and nothing is pushed along the plates.
// Penalties grow with the penetration, but not without end, and are taken back
// with a step. Plates that do not cover the ends of fibers leave these alone.
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



/** The order at which a difference gets smaller with its step. */
std::string
order(const std::vector<double> &errors)
{
  double least = 1e300;
  for (unsigned int k = 1; k < errors.size(); ++k)
    least = std::min(least, std::log2(errors[k - 1] / errors[k]));
  std::cout << "observed order " << least << std::endl;
  return least > 1.8 ? "2" : "LESS THAN 2";
}



void
derivatives()
{
  for (const std::string element : {"hermite", "director"})
    for (unsigned int seed = 0; seed < 3; ++seed)
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
        const auto   along    = plates.slope_and_curvature(scene.state, motion);
        const double slope    = dot(residual, motion);
        const double curvature = dot(tangent, motion);
        std::vector<double> of_energy, of_residual;
        for (const double h : {4e-3, 2e-3, 1e-3})
          {
            press.go(h, motion);
            const double forward_energy = press.energy();
            Motion       change         = press.residual();
            press.go(-h, motion);
            const double backward_energy = press.energy();
            const Motion backward        = press.residual();
            double       error           = 0.;
            for (unsigned int b = 0; b < change.size(); ++b)
              error += ((change[b] - backward[b]) / (2. * h) - tangent[b])
                         .norm_square();
            of_residual.push_back(std::sqrt(error));
            of_energy.push_back(
              std::abs((forward_energy - backward_energy) / (2. * h) - slope));
          }
        double across = 0.;
        for (const Tensor<1, 3> &force : residual)
          across = std::max({across, std::abs(force[0]), std::abs(force[1])});
        deallog << element << ", seed " << seed << ": gradient of order "
                << order(of_energy) << ", tangent of order "
                << order(of_residual) << ", along a motion "
                << along.first / slope << " and " << along.second / curvature
                << ", across " << across << std::endl;
      }
}



/** A level fiber of length 40, and plates as deep in it as they are asked to.
 */
class LevelFiber
{
public:
  LevelFiber(const std::array<double, 2> &extent = {})
    : scene(
        {line(Tensor<1, 3>({-20., 0., 0.}), Tensor<1, 3>({1., 0., 0.}), 40.)},
        {n_intervals})
    , plates(scene.space, pressed_by("t"), threshold, extent)
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
  const double first = 40. * 0.2 * numbers::PI / 4.;
  deallog << "force of the first penalty over the expected one "
          << fiber.force(0.03) / (first * 0.025) << std::endl;

  // Aims at three quarters of the threshold.
  fiber.plates.update(fiber.scene.state);
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



/** Half of the fiber is covered; work and energy of a step from nothing. */
void
covered()
{
  for (const double extent : {0., 20.})
    {
      LevelFiber   fiber(std::array<double, 2>{{extent, extent}});
      const double force = fiber.force(0.1);
      deallog << "extent " << extent << ": force over length " << force / 40.
              << ", distance " << fiber.reported("plate_distance[mm]")
              << ", work " << fiber.reported("external_work[N*mm]") / force
              << " times force";
      std::map<std::string, double> values;
      fiber.plates.report(fiber.scene.state, values);
      if (values.count("plate_pressure[MPa]") > 0)
        deallog << ", pressure over force "
                << values.at("plate_pressure[MPa]") / force;
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
}
