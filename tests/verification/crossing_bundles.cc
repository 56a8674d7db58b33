// Two bundles of seven clamped fibers cross at a right angle and are pressed
// together. The force agrees with that of an explicit code (Yade), 1.073 N, to
// one percent; without friction it would be five percent smaller.
#include <heddle/contributions/fiber_contact.h>
#include <heddle/contributions/fiber_friction.h>

#include "../contributions/scene.h"

#include <iostream>

const double radius = 0.5, length = 40., approach = 2., reference = 1.073;

/** Distance of neighbouring axes [mm]. */
const double spacing = 1.02;



/** The fibers of a bundle along x (0) or y (1), their middle at @p height. */
void
add_bundle(const unsigned int               direction,
           const double                     height,
           std::vector<Textile::FiberPath> &paths)
{
  for (unsigned int i = 0; i < 7; ++i)
    {
      const double angle    = i * numbers::PI / 3.;
      const double distance = i < 6 ? spacing : 0.;
      Tensor<1, 3> middle, half;
      half[direction]       = 0.5 * length;
      middle[1 - direction] = distance * std::cos(angle);
      middle[2]             = height + distance * std::sin(angle);
      paths.push_back(
        straight_path(middle - half, middle + half, /*n_knots=*/21, radius));
    }
}



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  Scene   scene;
  scene.fibers.element_kind           = Heddle::Beam::ElementKind::director;
  scene.fibers.material.axial_modulus = 1000.;
  scene.fibers.material.poisson_ratio = 0.3;
  scene.newton.max_iterations         = 200;
  for (const std::string end : {"first end", "last end"})
    {
      scene.clamp(end, "0, 1, 2, 3, 4, 5, 6");
      auto &support           = scene.clamp(end, "7, 8, 9, 10, 11, 12, 13");
      support.displacement[2] = "-" + std::to_string(approach) + "*t";
    }
  std::vector<Textile::FiberPath> paths;
  add_bundle(0, 0., paths);
  add_bundle(1, (std::sqrt(3.) + 1.) * spacing, paths);
  scene.build(paths);

  Contact::ContactParameters contact;
  contact.threshold               = 0.002;
  contact.friction                = 0.1;
  contact.reversible_displacement = 0.01;
  const auto touch =
    std::make_shared<Contributions::FiberContact>(*scene.space, contact);
  scene.contributions.push_back(touch);
  scene.contributions.push_back(std::make_shared<Contributions::FiberFriction>(
    *scene.space, contact, *touch));
  bool               converged = true;
  const unsigned int n_steps   = 10;
  for (unsigned int step = 1; step <= n_steps && converged; ++step)
    converged = scene.step(double(step) / n_steps).converged;

  auto         values = scene.report();
  const double lower =
    values["support_1_force_z[N]"] + values["support_3_force_z[N]"];
  const double upper =
    values["support_2_force_z[N]"] + values["support_4_force_z[N]"];
  std::cout << "force " << lower << ", dissipated "
            << values["friction_dissipated[N*mm]"] << std::endl;
  const bool good = converged && std::abs(lower / reference - 1.) < 0.01;
  deallog << "converged " << converged << ", forces balance "
          << (std::abs(upper / lower + 1.) < 1e-4) << ", within 1 % "
          << (std::abs(lower / reference - 1.) < 0.01) << verdict(good)
          << std::endl;
}
