// A strand of a core and one or two layers of helical wires is stretched, its
// ends held against rotation. To first order, and as long as the wires bend and
// twist for nothing, the force and the torque are those of Hruska,
//
//   F = E (A_c + sum n A_w cos^3 b) eps,   M = sum n r E A_w cos^2 b sin b eps,
//
// summed over layers of n wires with the lay angle b; friction has nothing to
// do. The closed form below is the same at a finite strain with the law of the
// elements, for wires that keep their distance r from the axis. The penetration
// of wires into what is below them lets them come closer: errors go with the
// threshold, and are larger for a second layer, which lies on the first one by
// points where it is laid the other way round. Six equal wires that touch a
// core of their own radius overlap each other at this lay angle, so the core is
// thicker. Errors and orders are printed to the screen; compared are bounds.
#include <heddle/base/choice.h>
#include <heddle/contributions/fiber_friction.h>

#include "../contributions/scene.h"

#include <iomanip>
#include <iostream>

const double core_radius = 1.03, wire_radius = 1.;
const double lay_angle = numbers::PI / 18., modulus = 1e5, strain = 0.002;



/** Wires around the axis. */
struct Layer
{
  unsigned int n_wires;
  double       distance; /**< from the axis [mm] */
  double       sense;    /**< of the lay, 1 or -1 */
};

/** The second layer is laid the other way round. */
const std::vector<Layer> all_layers = {
  {6, core_radius + wire_radius, 1.},
  {12, core_radius + 3. * wire_radius, -1.}};

/** One pitch of the first layer [mm]. */
const double length =
  2. * numbers::PI * all_layers.front().distance / std::tan(lay_angle);



/** Core and wires, at the knots of elements of degree 2. */
std::vector<Textile::FiberPath>
strand(const std::vector<Layer> &layers, const unsigned int n_elements)
{
  const unsigned int              n_knots = 2 * n_elements + 1;
  std::vector<Textile::FiberPath> paths   = {straight_path(
    Tensor<1, 3>(), Tensor<1, 3>({0., 0., length}), n_knots, core_radius)};
  for (const Layer &layer : layers)
    for (unsigned int wire = 0; wire < layer.n_wires; ++wire)
      {
        Textile::FiberPath path;
        path.radius           = wire_radius;
        path.reference_length = length / std::cos(lay_angle);
        for (unsigned int i = 0; i < n_knots; ++i)
          {
            const double z = length * i / (n_knots - 1);
            const double angle =
              2. * numbers::PI * wire / layer.n_wires +
              layer.sense * z * std::tan(lay_angle) / layer.distance;
            path.points.push_back(
              Tensor<1, 3>({layer.distance * std::cos(angle),
                            layer.distance * std::sin(angle),
                            z}));
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
closed_form(const std::vector<Layer> &layers)
{
  const auto force = [](const double radius, const double stretch) {
    return modulus * numbers::PI * radius * radius * 0.5 * stretch *
           (stretch * stretch - 1.);
  };
  Resultant    sum    = {force(core_radius, 1. + strain), 0.};
  const double around = length * std::tan(lay_angle),
               along  = length * (1. + strain);
  const double now    = std::hypot(around, along);
  const double wire   = force(wire_radius, now / std::hypot(around, length));
  for (const Layer &layer : layers)
    {
      sum.force += layer.n_wires * wire * along / now;
      sum.torque +=
        layer.sense * layer.n_wires * wire * around / now * layer.distance;
    }
  return sum;
}



struct Outcome
{
  double force_error, torque_error; /**< relative */
  bool   converged;
};



Outcome
stretch(const unsigned int n_layers,
        const double       threshold,
        const double       friction)
{
  const std::vector<Layer>   layers(all_layers.begin(),
                                  all_layers.begin() + n_layers);
  Contact::ContactParameters contact;
  contact.threshold = threshold;
  contact.friction  = friction;
  Scene scene;
  scene.fibers.element_kind           = Heddle::Beam::ElementKind::director;
  scene.fibers.degree                 = 2;
  scene.fibers.material.axial_modulus = modulus;
  scene.fibers.material.poisson_ratio = 0.;
  scene.newton.damping                = 0.;
  for (const std::string ends : {"first end", "last end"})
    {
      auto &support = scene.add_support();
      support.nodes.nodes =
        Heddle::choice<Heddle::Contributions::ChosenNodes>(ends);
      support.displacement = {
        {"0",
         "0",
         ends == "first end" ? "0" : std::to_string(strain) + "*z*t"}};
    }
  scene.build(strand(layers, /*n_elements=*/24));
  const auto touch =
    std::make_shared<Contributions::FiberContact>(*scene.space, contact);
  scene.contributions.push_back(touch);
  if (friction > 0.)
    scene.contributions.push_back(
      std::make_shared<Contributions::FiberFriction>(
        *scene.space, contact, *touch));

  const auto      first     = scene.step(0.5);
  const auto      second    = scene.step(1.);
  auto            values    = scene.report();
  const Resultant reference = closed_form(layers);
  Outcome         outcome;
  outcome.force_error = values["support_2_force_z[N]"] / reference.force - 1.;
  outcome.torque_error =
    values["support_2_moment_z[N*mm]"] / reference.torque - 1.;
  outcome.converged = first.converged && second.converged;
  std::cout << "layers " << n_layers << ", threshold " << threshold << ", mu "
            << friction << ": " << std::setprecision(2) << first.iterations
            << " + " << second.iterations << " iterations, error of the force "
            << 100. * outcome.force_error << " %, of the torque "
            << 100. * outcome.torque_error << " %" << std::endl;
  return outcome;
}



struct Case
{
  unsigned int n_layers;
  double       threshold, friction;
};



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  double  before = 0.;
  for (const Case &one : std::vector<Case>{{1, 4e-4, 0.},
                                           {1, 2e-4, 0.},
                                           {1, 2e-4, 0.1},
                                           {2, 1e-3, 0.},
                                           {2, 5e-4, 0.}})
    {
      const Outcome outcome =
        stretch(one.n_layers, one.threshold, one.friction);
      if (before != 0. && one.friction == 0.)
        std::cout << "  order " << std::log2(before / outcome.force_error)
                  << std::endl;
      before             = one.friction == 0. ? outcome.force_error : 0.;
      const double bound = 10. * one.threshold;
      deallog << "layers " << one.n_layers << ", threshold " << one.threshold
              << ", friction " << one.friction << ": converged "
              << outcome.converged << ", error of the force below "
              << 100. * bound << " % "
              << (std::abs(outcome.force_error) < bound) << ", of the torque "
              << (std::abs(outcome.torque_error) < 2. * bound) << std::endl;
    }
}
