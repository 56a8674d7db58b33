// A fiber lies across another, is pressed onto it by N and dragged to and fro
// along it. Friction follows Coulomb's law with a reversible displacement: the
// force rises by mu N / u_r per displacement, stays at mu N, turns around with
// the motion; what it does in a cycle is what the step by step sum says.
#include <heddle/base/choice.h>
#include <heddle/contributions/fiber_friction.h>

#include "scene.h"

const double radius = 1., length = 8., force = 1., friction = 0.3;

/** As a multiple of the radius, which is 1. */
const double reversible = 0.05, amplitude = 0.2;



/** Two short stiff fibers; the upper one is moved in x by @p drag. The lower
 * one is of the set "core". */
std::shared_ptr<Contributions::FiberContact>
describe(Scene                      &scene,
         Contact::ContactParameters &contact,
         const std::string          &element,
         const double                modulus,
         const std::string          &drag,
         const std::string          &pull)
{
  scene.fibers.element_kind =
    Heddle::choice<Heddle::Beam::ElementKind>(element);
  scene.fibers.material.axial_modulus = modulus;
  scene.newton.residual_tolerance     = 1e-12;
  contact.friction                    = friction;
  contact.reversible_displacement     = reversible;
  scene.clamp("first end", "0");
  scene.clamp("last end", "0");
  for (const std::string end : {"first end", "last end"})
    {
      auto &support        = scene.clamp(end, "1");
      support.displacement = {{drag, "0", "free"}};
      auto &load           = scene.add_load();
      load.nodes.nodes =
        Heddle::choice<Heddle::Contributions::ChosenNodes>(end);
      load.nodes.fibers = "1";
      load.force        = {{pull, "0", "-0.5"}};
    }
  const Tensor<1, 3> x({1., 0., 0.}), y({0., 1., 0.}), z({0., 0., 1.});
  const double       half = 0.5 * length, height = 1.999 * radius;
  auto               lower = straight_path(-half * x, half * x, 8, radius);
  lower.set                = "core";
  scene.build(
    {lower,
     straight_path(height * z - half * y, height * z + half * y, 8, radius)});
  const auto touch =
    std::make_shared<Contributions::FiberContact>(*scene.space, contact);
  scene.contributions.push_back(touch);
  scene.contributions.push_back(std::make_shared<Contributions::FiberFriction>(
    *scene.space, contact, *touch));
  return touch;
}



/** Force of friction on the fiber that is dragged, over mu N. */
double
resistance(Scene &scene)
{
  auto values = scene.report();
  return (values["support_3_force_x[N]"] + values["support_4_force_x[N]"]) /
         (friction * force);
}



/** What contact elements say acts on that fiber, and how many of them slip. */
std::pair<Tensor<1, 3>, double>
told_by_elements(const Scene &scene, const Contributions::FiberContact &contact)
{
  const auto forces = std::dynamic_pointer_cast<Contributions::FiberFriction>(
                        scene.contributions.back())
                        ->tangential_forces(*scene.state);
  Tensor<1, 3> sum;
  double       n_touching = 0., n_slipping = 0.;
  for (unsigned int i = 0; i < forces.size(); ++i)
    {
      const auto &element = contact.elements()[i];
      sum += (element.fiber_a == 1 ? 1. : -1.) * forces[i].on_a;
      n_touching += element.force > 0.;
      n_slipping += std::abs(forces[i].ratio - 1.) < 1e-12;
    }
  return {sum, n_slipping / n_touching};
}



/** To three digits behind the point, zero without a sign. */
double
rounded(const double value)
{
  return std::round(1e3 * value) / 1e3 + 0.;
}



/** One and a quarter cycles: values at the marks, and the loop's area. */
void
cycle(const std::string &element, const unsigned int steps_per_quarter)
{
  // A triangle: up to the amplitude at 1, to minus that at 3, up again at 5.
  const std::string drag =
    std::to_string(amplitude * 2. / numbers::PI) + "*asin(sin(0.5*pi*t))";
  Scene                      scene;
  Contact::ContactParameters contact;
  describe(scene, contact, element, 1e6, drag, "0");
  bool   converged = scene.step(0.).converged;
  double area = 0., before = resistance(scene), stored = 0., marks[4] = {};
  double at_one = 0.;
  for (unsigned int k = 1; k <= 5 * steps_per_quarter; ++k)
    {
      const double t    = double(k) / steps_per_quarter;
      converged         = scene.step(t).converged && converged;
      const double now  = resistance(scene);
      const bool   back = t > 1. + 1e-9 && t < 3. + 1e-9;
      if (t > 1. + 1e-9)
        area += friction * force * 0.5 * (now + before) * (back ? -1. : 1.) *
                amplitude / steps_per_quarter;
      before = now;
      if (k == steps_per_quarter)
        {
          auto values = scene.report();
          at_one      = values["friction_dissipated[N*mm]"];
          stored      = values["friction_stored[N*mm]"];
        }
      for (unsigned int i = 0; i < 4; ++i)
        if (std::abs(t - std::array<double, 4>{{0.125, 1., 1.25, 3.}}[i]) <
            1e-9)
          marks[i] = now;
    }
  auto         values     = scene.report();
  const double dissipated = values["friction_dissipated[N*mm]"] - at_one +
                            values["friction_stored[N*mm]"] - stored;
  const double exact =
    4. * friction * force * radius * (amplitude - reversible);
  deallog << element << ", " << steps_per_quarter
          << " steps per quarter: " << (converged ? "" : "not converged, ")
          << "force over mu N at u_r/2 " << rounded(marks[0]) << ", at the end "
          << rounded(marks[1]) << ", back by u_r " << rounded(marks[2])
          << ", at the other end " << rounded(marks[3]) << ", area over exact "
          << rounded(area / exact) << ", dissipated over area "
          << rounded(dissipated / area)
          << verdict(converged && std::abs(dissipated / area - 1.) < 1e-3)
          << std::endl;
}



/** A pull of half of mu N, once applied, is held for a hundred steps. */
void
hold(const std::string &element)
{
  Scene                      scene;
  Contact::ContactParameters contact;
  describe(scene,
           contact,
           element,
           /*modulus=*/1e4,
           "free",
           std::to_string(0.25 * friction * force) + "*t");
  bool converged     = scene.step(0.).converged;
  converged          = scene.step(1.).converged && converged;
  const double began = scene.block(1, 4)[0];
  for (unsigned int k = 1; k <= 100; ++k)
    converged = scene.step(1.).converged && converged;
  const double creep = (scene.block(1, 4)[0] - began) / began;
  deallog << element << ", a hundred steps of half the force of slip: "
          << (converged ? "" : "not converged, ") << "displacement over u_r "
          << rounded(began / reversible)
          << ", creep below 1e-8 of it: " << (std::abs(creep) < 1e-8)
          << verdict(converged && std::abs(creep) < 1e-8) << std::endl;
}



/** Force of slip over that of the coefficient, with others for this pair. */
void
coefficients(const std::string &what, const double expected)
{
  Scene                      scene;
  Contact::ContactParameters contact;
  if (what == "crossed")
    contact.crossed_friction = 0.5;
  else
    contact.friction_of_sets.emplace(what, 0.2);
  const auto touch = describe(scene, contact, "director", 1e6, "0.2*t", "0");
  bool       converged = scene.step(0.).converged;
  converged            = scene.step(1.).converged && converged;
  const double force   = resistance(scene);
  const auto   told    = told_by_elements(scene, *touch);
  const double drags   = -told.first[0] / (friction * ::force);
  deallog << what << ": force of slip over mu N " << rounded(force)
          << ", told by elements " << rounded(drags) << ", across "
          << rounded(told.first[1]) << " and " << rounded(told.first[2])
          << ", part that slips " << told.second
          << verdict(converged && std::abs(force - expected) < 1e-3 &&
                     std::abs(drags - expected) < 1e-3)
          << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  for (const std::string element : {"hermite", "director"})
    {
      for (const unsigned int steps : {8, 16, 32})
        cycle(element, steps);
      hold(element);
    }
  coefficients("crossed", 0.5);
  coefficients("core-", 2. / 3.);
  coefficients("core-core", 1.);
}
