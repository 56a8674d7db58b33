// A fiber is pulled around a drum and slips everywhere: the ratio of the
// tensions is exp(lambda phi), where friction acts on the surface of the fiber,
//
//   x mu lambda^2 + lambda - (1 - x) mu = 0,   x = R / (R_0 + R),
//
// which is Euler's mu for a thin fiber. The fiber's bending stiffness is small
// enough not to matter; its slack end is held by a force and the other one is
// drawn along the tangent. Ratios and orders are printed to the screen;
// compared are bounds.
#include <heddle/contributions/fiber_friction.h>

#include "../contributions/scene.h"

#include <iomanip>
#include <iostream>

const double drum_radius = 1., radius = 0.01, leg = 0.3, slack_force = 0.1;
const double distance = drum_radius + radius;



/** Particles at equal distances on a leg, the arc by @p angle, and a leg. */
Textile::FiberPath
wrapped_path(const double angle, const unsigned int n_elements)
{
  const auto on_arc = [](const double a) {
    return distance * Tensor<1, 3>({std::cos(a), 0., std::sin(a)});
  };
  const auto along = [](const double a) {
    return Tensor<1, 3>({-std::sin(a), 0., std::cos(a)});
  };
  Textile::FiberPath path;
  path.radius             = radius;
  path.reference_length   = 2. * leg + distance * angle;
  const unsigned int last = 2 * n_elements; // the element has three nodes
  for (unsigned int i = 0; i <= last; ++i)
    {
      const double s = path.reference_length * i / last - leg;
      const double a = std::min(std::max(s / distance, 0.), angle);
      path.points.push_back(on_arc(a) + (s - distance * a) * along(a));
    }
  return path;
}



/** The exponent per angle in sustained slip. */
double
exponent(const double friction)
{
  const double x = radius / distance;
  return (std::sqrt(1. + 4. * friction * friction * x * (1. - x)) - 1.) /
         (2. * friction * x);
}



struct Outcome
{
  double error;        /**< of the exponent, relative */
  double energy_error; /**< of the dissipation in the last step, relative */
  bool   converged;
};



Outcome
pull(const double angle, const double friction, const unsigned int n_elements)
{
  Contact::ContactParameters contact;
  contact.friction        = friction;
  contact.search_distance = 0.1;
  Scene scene;
  scene.fibers.element_kind               = Heddle::Beam::ElementKind::director;
  scene.fibers.degree                     = 2;
  scene.fibers.material.axial_modulus     = 1e5;
  scene.fibers.material.poisson_ratio     = 0.;
  scene.fibers.material.bending_stiffness = 2.5e-5;
  scene.newton.damping                    = 0.;
  scene.clamp("all", "0");
  auto &slack        = scene.add_support();
  slack.nodes.fibers = "1";
  slack.nodes.nodes  = Heddle::Contributions::ChosenNodes::first_end;
  slack.displacement = {{"0", "0", "free"}};
  auto &load         = scene.add_load();
  load.nodes.fibers  = "1";
  load.nodes.nodes   = Heddle::Contributions::ChosenNodes::first_end;
  load.force  = {{"0", "0", "-" + std::to_string(slack_force) + "*min(t,1)"}};
  auto &drawn = scene.add_support();
  drawn.nodes.fibers  = "1";
  drawn.nodes.nodes   = Heddle::Contributions::ChosenNodes::last_end;
  const double motion = 0.02; // in a step [mm]
  drawn.displacement  = {
     {std::to_string(-motion * std::sin(angle)) + "*max(t-1,0)",
      "0",
      std::to_string(motion * std::cos(angle)) + "*max(t-1,0)"}};
  Textile::FiberPath drum = straight_path(Tensor<1, 3>({0., -0.06, 0.}),
                                          Tensor<1, 3>({0., 0.06, 0.}),
                                          3,
                                          drum_radius);
  scene.build({drum, wrapped_path(angle, n_elements)});
  const auto touch =
    std::make_shared<Contributions::FiberContact>(*scene.space, contact);
  scene.contributions.push_back(touch);
  scene.contributions.push_back(std::make_shared<Contributions::FiberFriction>(
    *scene.space, contact, *touch));

  // The last step slips everywhere: its work is that of both ends.
  Outcome            outcome = {0., 0., true};
  double             before = 0., tension = 0.;
  const unsigned int n_steps = 3. + 2. * angle / numbers::PI;
  for (unsigned int step = 1; step <= n_steps && outcome.converged; ++step)
    {
      outcome.converged       = scene.step(step).converged;
      auto         values     = scene.report();
      const double dissipated = values["friction_dissipated[N*mm]"];
      tension                 = std::hypot(values["support_3_force_x[N]"],
                           values["support_3_force_z[N]"]);
      outcome.energy_error =
        (dissipated - before) / ((tension - slack_force) * motion) - 1.;
      before = dissipated;
    }
  outcome.error =
    std::log(tension / slack_force) / (angle * exponent(friction)) - 1.;
  std::cout << std::fixed << std::setprecision(4) << "angle " << angle
            << ", friction " << friction << ", " << n_elements
            << " elements: ratio of tensions " << tension / slack_force
            << " instead of " << std::exp(angle * exponent(friction))
            << ", error of the exponent " << 100. * outcome.error
            << " %, of the energy " << 100. * outcome.energy_error << " %"
            << std::endl;
  return outcome;
}



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  struct Case
  {
    double       turns, friction;
    unsigned int per_turn; /**< elements */
    double       bound;
  };
  for (const Case &one : std::vector<Case>{{0.25, 0.1, 20, 0.01},
                                           {0.25, 0.1, 40, 0.005},
                                           {0.25, 0.1, 80, 0.002},
                                           {0.25, 0.3, 20, 0.01},
                                           {0.25, 0.3, 40, 0.005},
                                           {0.5, 0.1, 40, 0.005},
                                           {0.5, 0.3, 20, 0.01},
                                           {0.5, 0.3, 40, 0.005}})
    {
      const Outcome outcome = pull(2. * numbers::PI * one.turns,
                                   one.friction,
                                   4 + std::lround(one.turns * one.per_turn));
      deallog << "turns " << one.turns << ", friction " << one.friction << ", "
              << one.per_turn << " elements per turn: converged "
              << outcome.converged << ", error of the exponent below "
              << 100. * one.bound << " % "
              << (std::abs(outcome.error) < one.bound)
              << ", dissipated is the work to 1 % "
              << (std::abs(outcome.energy_error) < 0.01) << std::endl;
    }
}
