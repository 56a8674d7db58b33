// Seven parallel fibers are clamped at one end, pressed together by line loads
// q on the six outer ones, and bent by a force P on the other end. Friction
// makes them one beam of up to 55 / 7 of the bending stiffness of seven.
//
// Beam theory: all fibers turn by theta, the row above the middle one slides by
// s, that below it by -s. With the area A and the distance h of the rows, the
// two rows of two fibers carry the axial strains +-(s' - h theta'), and each is
// held by the shear flow K s, K = 2 mu q / u_r, as the forces of its four
// contacts add up to 2 q whatever each of them is. The loads keep their
// directions, which counts in the second order: with Q = sqrt(3) q on a row,
//
//   7/2 EI theta'^2 + 2 EA (s' - h theta')^2 + K s^2
//     + 2 Q (s theta - h theta^2 / 2) - P theta
//
// is stationary. Both unknowns are sines of (n - 1/2) pi x / L.
//
// In slip, where K s is replaced by what does not change, the stiffness is that
// of K = 0; when the force turns back it is again that of the beginning. What
// the force puts into a cycle is dissipated.
#include <heddle/contributions/fiber_contact.h>
#include <heddle/contributions/fiber_friction.h>

#include "../contributions/scene.h"

#include <iomanip>
#include <iostream>

const double radius = 0.5, length = 40., modulus = 1000., friction = 0.3;

/** Line load on each outer fiber [N/mm]. */
const double line_load = 0.01;

/** Stiffness of seven loose fibers [N/mm]. */
const double loose = 3. * 7. * modulus * numbers::PI / 4. *
                     std::pow(radius, 4) / std::pow(length, 3);



/** Force on the end per its displacement, for the shear flow @p k_s per slip.
 */
double
theory(const double k_s)
{
  const double area    = numbers::PI * radius * radius;
  const double axial   = modulus * area;
  const double bending = 0.25 * axial * radius * radius;
  const double h       = std::sqrt(3.) * radius;
  const double row     = std::sqrt(3.) * line_load;
  double       sum     = 0.;
  for (unsigned int n = 1; n < 2000; ++n)
    {
      const double k = (n - 0.5) * numbers::PI / length;
      const double tt =
        (7. * bending + 4. * axial * h * h) * k * k - 2. * row * h;
      const double ts = -4. * axial * h * k * k + 2. * row;
      const double ss = 4. * axial * k * k + 2. * k_s;
      sum += 2. / (length * k * k) / (tt - ts * ts / ss);
    }
  return 1. / sum;
}



/** The bundle, pressed together. */
class Bundle
{
public:
  Bundle(const unsigned int n_elements, const double reversible)
  {
    scene.fibers.element_kind           = Heddle::Beam::ElementKind::director;
    scene.fibers.material.axial_modulus = modulus;
    scene.fibers.material.poisson_ratio = 0.3;
    scene.newton.residual_tolerance     = 1e-7;
    scene.clamp("first end");
    auto &pressure = scene.add_load();
    for (unsigned int d = 1; d < 3; ++d)
      pressure.force_per_length[d] = "-" + std::to_string(line_load) + "*" +
                                     std::string(1, "xyz"[d]) + "*min(t,1)";

    // The load factor beyond 1 is the force on the end.
    auto &pull       = scene.add_load();
    pull.nodes.nodes = Heddle::Contributions::ChosenNodes::last_end;
    pull.force[2]    = "if(t>1,(t-2)/7,0)";
    std::vector<Textile::FiberPath> paths;
    for (unsigned int i = 0; i < 7; ++i)
      {
        const double       angle    = i * numbers::PI / 3.;
        const double       distance = i < 6 ? 2. * radius : 0.;
        const Tensor<1, 3> begin(
          {0., distance * std::cos(angle), distance * std::sin(angle)});
        paths.push_back(straight_path(begin,
                                      begin + Tensor<1, 3>({length, 0., 0.}),
                                      n_elements + 1,
                                      radius));
      }
    scene.build(paths);
    contact.threshold               = 0.002;
    contact.friction                = friction;
    contact.reversible_displacement = reversible;
    const auto touch =
      std::make_shared<Contributions::FiberContact>(*scene.space, contact);
    scene.contributions.push_back(touch);
    scene.contributions.push_back(
      std::make_shared<Contributions::FiberFriction>(
        *scene.space, contact, *touch));
    converged = scene.step(1.).converged;
  }

  /** @return the displacement of the end under @p force. */
  double
  bend(const double force)
  {
    converged = scene.step(2. + force).converged && converged;
    return scene.report()["load_2_displacement_z[mm]"];
  }

  double
  dissipated()
  {
    return scene.report()["friction_dissipated[N*mm]"];
  }

  bool converged;

private:
  Scene                      scene;
  Contact::ContactParameters contact;
};



/** Say whether the @p value is that of theory within the @p bound. */
void
judge(const std::string &name,
      const double       value,
      const double       exact,
      const double       bound,
      const bool         converged)
{
  const double error = value / exact - 1.;
  std::cout << name << ": " << std::setprecision(5) << value << ", theory "
            << exact << ", error " << std::setprecision(2) << 100. * error
            << " %" << std::endl;
  const bool good = converged && std::abs(error) < bound;
  deallog << name << ": theory " << std::setprecision(3) << exact
          << ", error below " << 100. * bound << " % " << good << verdict(good)
          << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  deallog << "bonded: " << std::setprecision(4) << 55. / 7. << std::endl;

  // As the reversible displacement shrinks, and with the elements.
  for (const double reversible : {0.02, 0.002, 0.0002})
    for (const unsigned int n_elements : {10, 20})
      if (n_elements == 10 || reversible == 0.0002)
        {
          Bundle             bundle(n_elements, reversible);
          const double       w = bundle.bend(0.003);
          std::ostringstream name;
          name << "stick, reversible displacement " << reversible << " R, "
               << n_elements << " elements";
          judge(name.str(),
                0.003 / w / loose,
                theory(2. * friction * line_load / (reversible * radius)) /
                  loose,
                n_elements == 10 ? 4e-3 : 2e-3,
                bundle.converged);
        }

  // A cycle between two forces at which the bundle slips nearly everywhere.
  const double reversible = 0.0002, most = 0.03, part = 0.003;
  const double stick =
    theory(2. * friction * line_load / (reversible * radius)) / loose;
  Bundle bundle(10, reversible);
  for (const double force : {0.009, 0.018, 0.024})
    bundle.bend(force);
  const double w_before = bundle.bend(most - part), w_most = bundle.bend(most);
  judge("slip",
        part / (w_most - w_before) / loose,
        theory(0.) / loose,
        1e-2,
        bundle.converged);
  const double begun = bundle.dissipated();
  double       force = most, before = w_most, area = 0.;
  for (const double next : {0.027,
                            0.008,
                            0.006,
                            0.003,
                            -0.03,
                            -0.027,
                            -0.008,
                            -0.006,
                            -0.003,
                            0.03})
    {
      const double w = bundle.bend(next);
      if (std::abs(next) == 0.027)
        judge(next > 0. ? "turned back" : "turned back again",
              (next - force) / (w - before) / loose,
              stick,
              4e-3,
              bundle.converged);
      area += 0.5 * (force + next) * (w - before);
      force  = next;
      before = w;
    }
  judge("cycle, dissipation over work",
        (bundle.dissipated() - begun) / area,
        1.,
        1.5e-3,
        bundle.converged);
}
