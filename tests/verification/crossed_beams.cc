// Two simply supported beams cross in their middles and just touch; the
// supports of the upper one come down by D. The force between them is that of
// three springs in series, D = F (1 / k1 + 1 / k2) + d(F), with k = 48 EI / L^3
// and the approach d of two crossing cylinders by the law of contact, whose
// penalty is adapted. With an odd number of elements the force acts amid one.
// Beams are of one material, or the upper one of another.
#include <heddle/base/choice.h>
#include <heddle/contributions/fiber_contact.h>

#include "../contributions/scene.h"

const double radius = 0.01, length = 1., modulus = 1e4, approach = 0.2 * radius;



/**
 * Force of two cylinders that cross at a right angle, at the distance @p h of
 * their axes. Where s is the length of the intermediate curve the axes are
 * $\sqrt{h^2 + 2 s^2}$ from each other.
 */
double
crossing_force(const double penalty, const double threshold, const double h)
{
  const Contact::NormalLaw law{0.5 * threshold * radius};
  const double             reach = std::sqrt(2. * radius * radius - h * h / 2.);
  const unsigned int       n     = 20000;
  double                   force = 0.;
  for (unsigned int i = 0; i < n; ++i)
    {
      const double s        = reach * ((2. * i + 1.) / n - 1.);
      const double distance = std::sqrt(h * h + 2. * s * s);
      force += 2. * reach / n * h / distance *
               law.pressure(penalty, 2. * radius - distance);
    }
  return force;
}



/** Force of the springs in series, by bisection in the penetration. */
double
exact_force(const double penalty, const double threshold, const double ratio)
{
  const double bending = modulus * M_PI / 4. * std::pow(radius, 4);
  const double beam    = 48. * bending / std::pow(length, 3);
  const double yields  = (1. + 1. / ratio) / beam;
  double       low = 0., high = approach;
  for (unsigned int i = 0; i < 50; ++i)
    {
      const double middle = 0.5 * (low + high);
      const double force =
        crossing_force(penalty, threshold, 2. * radius - middle);
      (force * yields + middle < approach ? low : high) = middle;
    }
  return crossing_force(penalty, threshold, 2. * radius - low);
}



/**
 * Both beams, simply supported; the upper one comes down. It is @p ratio times
 * as stiff, by a material of its own unless this is 1.
 */
void
describe(Scene &scene, const unsigned int n_elements, const double ratio)
{
  scene.fibers.material.axial_modulus = modulus;
  if (ratio != 1.)
    {
      scene.fibers.materials.push_back(
        std::make_shared<Simulation::MaterialParameters>("/Fiber/Material 1"));
      scene.fibers.materials[0]->fibers                 = "1";
      scene.fibers.materials[0]->material.axial_modulus = ratio * modulus;
    }
  scene.newton.damping            = 0.;
  scene.newton.residual_tolerance = 1e-8;
  for (const std::string fiber : {"0", "1"})
    for (const std::string end : {"first end", "last end"})
      {
        auto &support        = scene.add_support();
        support.nodes.fibers = fiber;
        support.nodes.nodes =
          Heddle::choice<Heddle::Contributions::ChosenNodes>(end);
        support.displacement = {{"0", "0", "0"}};
        if (end == "last end")
          support.displacement[fiber == "0" ? 0 : 1] = "free";
        if (fiber == "1")
          support.displacement[2] = "-" + std::to_string(approach) + "*t";
      }
  std::vector<Textile::FiberPath> paths;
  for (unsigned int direction = 0; direction < 2; ++direction)
    {
      Tensor<1, 3> half, middle;
      half[direction] = 0.5 * length;
      middle[2]       = 2. * radius * direction;
      paths.push_back(
        straight_path(middle - half, middle + half, n_elements + 1, radius));
    }
  scene.build(paths);
}



/** Error of the force; @p before is that of a third of the elements. */
double
test(const unsigned int n_elements,
     const double       threshold,
     const double       ratio,
     const double       before)
{
  Contact::ContactParameters contact;
  contact.threshold = threshold;
  Scene scene;
  describe(scene, n_elements, ratio);
  const auto touch =
    std::make_shared<Contributions::FiberContact>(*scene.space, contact);
  scene.contributions.push_back(touch);
  const auto result  = scene.solve(1.);
  double     penalty = 0.;
  for (const auto &element : touch->elements())
    penalty = std::max(penalty, element.penalty);

  // The round-off of the axial forces, E A 1e-16 per node, is 1e-6 of the
  // force.
  auto         values = scene.report();
  const double lower =
    values["support_1_force_z[N]"] + values["support_2_force_z[N]"];
  const double upper =
    values["support_3_force_z[N]"] + values["support_4_force_z[N]"];
  const double exact = exact_force(penalty, threshold, ratio);
  const double error = lower / exact - 1.;
  deallog << "elements " << n_elements << ", threshold " << threshold
          << ", ratio " << ratio << ": converged " << result.converged
          << ", forces balance " << (std::abs(upper / lower + 1.) < 1e-5)
          << ", error " << std::round(1e5 * error) << "e-5";
  if (before != 0.)
    deallog << ", order about "
            << std::round(std::log(before / error) / std::log(3.));
  deallog << verdict(result.converged && std::abs(error) < 3e-3) << std::endl;
  return error;
}



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  for (const double ratio : {1., 10.})
    for (const double threshold : {0.02, 0.01})
      {
        double error = 0.;
        for (const unsigned int n_elements : {5, 15, 45})
          error = test(n_elements, threshold, ratio, error);
      }
}
