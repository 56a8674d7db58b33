// A strand of a core and six helical wires is stretched, its ends held against
// rotation. To first order, and as long as the wires bend and twist for
// nothing, the force and the torque are those of Hruska,
//
//   F = E (A_c + 6 A_w cos^3 b) eps,   M = 6 r E A_w cos^2 b sin b eps,
//
// with the lay angle b; friction has nothing to do. The closed form below is
// the same at a finite strain with the law of the elements, for wires that keep
// their distance r from the axis. The penetration of the wires into the core
// lets them come closer: errors go with the threshold. Six equal wires that
// touch a core of their own radius overlap each other at this lay angle, so the
// core is thicker. Errors and orders are printed to the screen; compared are
// bounds.
#include <heddle/base/choice.h>
#include <heddle/contributions/fiber_friction.h>

#include "../contributions/scene.h"

#include <iomanip>
#include <iostream>

const double core_radius = 1.03, wire_radius = 1., distance = 2.03;
const double lay_angle = numbers::PI / 18., modulus = 1e5, strain = 0.002;
const double pitch = 2. * numbers::PI * distance / std::tan(lay_angle);



/** Core and wires, one pitch long, at the knots of elements of degree 2. */
std::vector<Textile::FiberPath>
strand(const unsigned int n_elements)
{
  const unsigned int              n_knots = 2 * n_elements + 1;
  std::vector<Textile::FiberPath> paths   = {straight_path(
    Tensor<1, 3>(), Tensor<1, 3>({0., 0., pitch}), n_knots, core_radius)};
  for (unsigned int wire = 0; wire < 6; ++wire)
    {
      Textile::FiberPath path;
      path.radius           = wire_radius;
      path.reference_length = pitch / std::cos(lay_angle);
      for (unsigned int i = 0; i < n_knots; ++i)
        {
          const double part  = double(i) / (n_knots - 1);
          const double angle = 2. * numbers::PI * (wire / 6. + part);
          path.points.push_back(Tensor<1, 3>({distance * std::cos(angle),
                                              distance * std::sin(angle),
                                              pitch * part}));
        }
      paths.push_back(path);
    }
  return paths;
}



/** Axial force [N] and torque [N mm]. */
struct Resultant
{
  double force, torque;
};



/** For wires that stay at their distance from the axis. */
Resultant
closed_form()
{
  const auto stress = [](const double stretch) {
    return modulus * 0.5 * stretch * (stretch * stretch - 1.);
  };
  const double core_area = numbers::PI * core_radius * core_radius,
               wire_area = numbers::PI * wire_radius * wire_radius;
  const double around    = 2. * numbers::PI * distance,
               along     = pitch * (1. + strain);
  const double now       = std::hypot(around, along);
  const double wire = 6. * wire_area * stress(now / std::hypot(around, pitch));
  return {core_area * stress(1. + strain) + wire * along / now,
          wire * around / now * distance};
}



struct Outcome
{
  double force_error, torque_error; /**< relative */
  bool   converged;
};



Outcome
stretch(const unsigned int n_elements,
        const double       threshold,
        const double       friction)
{
  Contact::ContactParameters contact;
  contact.threshold = threshold;
  contact.friction  = friction;
  Scene scene;
  scene.fibers.element_kind           = Heddle::Beam::ElementKind::director;
  scene.fibers.degree                 = 2;
  scene.fibers.material.axial_modulus = modulus;
  scene.fibers.material.poisson_ratio = 0.;
  scene.newton.damping                = 0.;
  // The first wire has a support of its own: the torque is six times its.
  for (const std::string fibers : {"all", "0, 2, 3, 4, 5, 6", "1"})
    {
      auto &support        = scene.add_support();
      support.nodes.fibers = fibers;
      support.nodes.nodes  = Heddle::choice<Heddle::Contributions::ChosenNodes>(
        fibers == "all" ? "first end" : "last end");
      support.displacement = {
        {"0", "0", fibers == "all" ? "0" : std::to_string(strain) + "*z*t"}};
    }
  scene.build(strand(n_elements));
  const auto touch =
    std::make_shared<Contributions::FiberContact>(*scene.space, contact);
  scene.contributions.push_back(touch);
  scene.contributions.push_back(std::make_shared<Contributions::FiberFriction>(
    *scene.space, contact, *touch));

  const auto      first     = scene.step(0.5);
  const auto      second    = scene.step(1.);
  auto            values    = scene.report();
  const Resultant reference = closed_form();
  const double    force =
    values["support_2_force_z[N]"] + values["support_3_force_z[N]"];
  const double torque = 6. * distance * values["support_3_force_y[N]"];
  Outcome      outcome;
  outcome.force_error  = force / reference.force - 1.;
  outcome.torque_error = torque / reference.torque - 1.;
  outcome.converged    = first.converged && second.converged;
  std::cout << "elements " << n_elements << ", threshold " << threshold
            << ", mu " << friction << ": " << std::setprecision(2)
            << first.iterations << " + " << second.iterations
            << " iterations, error of the force " << 100. * outcome.force_error
            << " %, of the torque " << 100. * outcome.torque_error << " %"
            << std::endl;
  return outcome;
}



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  double  before = 0.;
  for (const auto &one : std::vector<std::pair<double, double>>{
         {4e-4, 0.}, {2e-4, 0.}, {2e-4, 0.1}})
    {
      const Outcome outcome = stretch(24, one.first, one.second);
      if (before != 0. && one.second == 0.)
        std::cout << "  order " << std::log2(before / outcome.force_error)
                  << std::endl;
      before             = outcome.force_error;
      const double bound = 10. * one.first;
      deallog << "threshold " << one.first << ", friction " << one.second
              << ": converged " << outcome.converged
              << ", error of the force below " << 100. * bound << " % "
              << (std::abs(outcome.force_error) < bound) << ", of the torque "
              << (std::abs(outcome.torque_error) < 2. * bound) << std::endl;
    }
}
