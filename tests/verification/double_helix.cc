// Two straight rods, side by side, are stretched and twisted into a double
// helix of one turn. The force per length by which they press on each other has
// a closed form (Meier, Popp, Wall, 2016), which depends on the radius r of the
// helix: R less half the penetration. The axial stiffness is such that the
// element, whose strain is that of Green and Lagrange, has the axial force of
// the reference at r = R.
//
// Two things converge: with the elements, the force to the closed form of the
// helix that was found; with the threshold, that helix to the one of rods that
// do not penetrate. Friction changes nothing but the number of iterations: by
// symmetry the rods do not slide along each other, and they roll for nothing.
// (The rods' ends are held at r = R: where they come closer,
// they also turn a little more.) Errors and orders are printed to the screen;
// compared are bounds, for the penalties, and with them the last digits, depend
// on the path of the iteration.
#include <heddle/contributions/fiber_friction.h>

#include "../contributions/scene.h"

#include <array>
#include <iomanip>
#include <iostream>

const double radius = 0.0095, length = 5., height = 5.0496472226;
const double axial_stiffness = 309501.27, bending = 7.8539816;



/**
 * Contact force per reference length [N/mm] of two rods that wind about each
 * other, p = lambda (N kappa + M tau^2): at distance @p r from the axis,
 * turning by @p angle within @p rise, stretched from @p reference.
 */
double
closed_form(const double r,
            const double angle     = 2. * numbers::PI,
            const double rise      = height,
            const double reference = length)
{
  const double arc       = std::hypot(rise, r * angle);
  const double stretch   = arc / reference;
  const double turning   = angle / arc;
  const double curvature = r * turning * turning;
  const double torsion   = turning * rise / arc;
  const double force =
    axial_stiffness * stretch * 0.5 * (stretch * stretch - 1.);
  const double moment = bending * curvature * stretch;
  return stretch * (force * curvature + moment * torsion * torsion);
}



/** Both rods, held at the bottom, stretched and twisted at the top. */
void
describe(Scene &scene, const unsigned int n_elements)
{
  scene.fibers.material.axial_modulus     = 1e9;
  scene.fibers.material.poisson_ratio     = 0.;
  scene.fibers.material.axial_stiffness   = axial_stiffness;
  scene.fibers.material.bending_stiffness = bending;
  scene.newton.damping                    = 0.;
  auto &bottom                            = scene.add_support();
  bottom.nodes.nodes  = Heddle::Contributions::ChosenNodes::first_end;
  bottom.displacement = {{"0", "0", "0"}};
  bottom.held_tangent = {"x"};
  auto &top           = scene.add_support();
  top.nodes.nodes     = Heddle::Contributions::ChosenNodes::last_end;
  top.displacement = {{"x*(cos(2*pi*t)-1)", "x*sin(2*pi*t)", "0.0496472226*t"}};
  top.held_tangent = {"x"};
  std::vector<Textile::FiberPath> paths;
  for (const double x : {-radius, radius})
    paths.push_back(straight_path(Tensor<1, 3>({x, 0., 0.}),
                                  Tensor<1, 3>({x, 0., length}),
                                  n_elements + 1,
                                  radius));
  scene.build(paths);
}



/** Contact whose forces keep their direction in the tangent. */
class UnturnedContact : public Contributions::FiberContact
{
public:
  using FiberContact::FiberContact;

  void
  set_geometric_stiffness(const bool) override
  {
  }
};



struct Outcome
{
  double       error;       /**< of the force, for the helix that was found */
  double       whole_error; /**< of the force, for rods that do not penetrate */
  unsigned int iterations;
  bool in_time; /**< in 20 iterations per step, on average; with friction
                   in 80 */
};



template <typename FiberContact = Contributions::FiberContact>
Outcome
twist(const unsigned int n_elements,
      const double       threshold,
      const double       friction = 0.)
{
  Contact::ContactParameters contact;
  contact.threshold = threshold;
  contact.friction  = friction;
  Scene scene;
  describe(scene, n_elements);
  const auto touch = std::make_shared<FiberContact>(*scene.space, contact);
  scene.contributions.push_back(touch);
  const unsigned int allowed = friction > 0. ? 80 : 20;
  scene.newton.max_iterations =
    std::max(scene.newton.max_iterations, 3 * allowed);
  if (friction > 0.)
    scene.contributions.push_back(
      std::make_shared<Contributions::FiberFriction>(
        *scene.space, contact, *touch));
  const unsigned int n_steps    = 16;
  unsigned int       iterations = 0;
  bool               converged  = true;
  for (unsigned int step = 1; step <= n_steps && converged; ++step)
    {
      const auto result = scene.step(double(step) / n_steps);
      converged         = result.converged;
      iterations += result.iterations;
    }

  double force = 0., weight = 0., overlap = 0., least = 1e9, most = 0.;
  for (const auto &element : touch->elements())
    if (std::abs(element.s_a - 0.5 * length) < 0.25 * length)
      {
        force += element.force;
        weight += element.weight;
        overlap -= element.weight * element.gap;
        least = std::min(least, element.force / element.weight);
        most  = std::max(most, element.force / element.weight);
      }
  const double pressure    = force / weight;
  const double penetration = overlap / weight;
  const double whole       = closed_form(radius);

  // The helix of the middle half, from its nodes.
  const auto position = [&scene](const unsigned int node) {
    return scene.state->current()[scene.state->local_block(0) + 2 * node];
  };
  const Tensor<1, 3> low  = position(n_elements / 4),
                     high = position(3 * n_elements / 4);
  const double half_turn =
    std::atan2(high[1], high[0]) - std::atan2(low[1], low[0]);
  Outcome outcome;
  outcome.error = pressure / closed_form(std::hypot(low[0], low[1]),
                                         half_turn,
                                         high[2] - low[2],
                                         0.5 * length) -
                  1.;
  outcome.whole_error = pressure / whole - 1.;
  std::cout << "elements " << n_elements << ", threshold " << threshold << ": "
            << iterations << " iterations, " << std::setprecision(3)
            << "penetration " << penetration / radius << " R, force per length "
            << std::setprecision(5) << pressure << std::setprecision(2)
            << ", error " << 100. * outcome.whole_error
            << " %, for the helix found " << 100. * outcome.error
            << " %, scatter along the middle half "
            << 100. * (most - least) / whole << " %" << std::endl;
  outcome.iterations = iterations;
  outcome.in_time    = converged && iterations < allowed * n_steps;
  return outcome;
}



/** Say whether the @p error is below @p bound; @p before is another one. */
void
judge(const std::string &name,
      const bool         in_time,
      const double       error,
      const double       bound,
      const double       before)
{
  if (before != 0.)
    std::cout << "  order " << std::log2(std::abs(before / error)) << std::endl;
  deallog << name << ": in equilibrium " << in_time << ", error below "
          << std::setprecision(3) << 100. * bound << " % "
          << (std::abs(error) < bound) << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  deallog << "closed form " << std::setprecision(6) << closed_form(radius)
          << verdict(std::abs(closed_form(radius) / 46.8452798 - 1.) < 1e-6)
          << std::endl;
  const std::array<double, 4> bounds = {{3e-2, 1.5e-3, 2e-4, 2e-4}};
  double                      before = 0.;
  for (unsigned int k = 0; k < 4; ++k)
    {
      const unsigned int n_elements = 4 << k;
      const Outcome      outcome    = twist(n_elements, 0.01);
      judge("against the helix found, " + std::to_string(n_elements) +
              " elements",
            outcome.in_time,
            outcome.error,
            bounds[k],
            before);
      before = outcome.error;
    }

  before = 0.;
  for (const double threshold : {0.04, 0.02, 0.01, 0.005})
    {
      const Outcome      outcome = twist(16, threshold);
      std::ostringstream name;
      name << "against the rods that do not penetrate, threshold " << threshold;
      judge(name.str(),
            outcome.in_time,
            outcome.whole_error,
            0.5 * threshold,
            before);
      before = outcome.whole_error;
    }

  // Close to equilibrium the tangent is exact where forces turn in it.
  const unsigned int turned   = twist(16, 0.02).iterations,
                     unturned = twist<UnturnedContact>(16, 0.02).iterations;
  deallog
    << "by forces that turn in the tangent a tenth of the iterations is saved: "
    << (turned < 0.9 * unturned) << std::endl;

  const Outcome outcome = twist(16, 0.01, /*friction=*/0.3);
  judge("with friction, against the helix found, 16 elements",
        outcome.in_time,
        outcome.error,
        2e-4,
        0.);
}
