// A fiber that winds once from end to end, as low as it is high, is pressed
// between two plates. Its ends are hinged, and by symmetry so is its middle:
// each half is a beam on two supports, which a plate presses at its crest,
// F = 48 EI w / l^3, or 48 EI w / l^3 (1 + 12 EI / kGA l^2) with shear, as long
// as the crest keeps a curvature (w below 0.8 of its height). w is by how much
// the crest gave way, less than a plate came by what it penetrates.
//
// The plates' work is what the fiber has stored, on the way there and back.
#include <heddle/base/choice.h>
#include <heddle/contributions/plates.h>

#include "../contributions/scene.h"

#include <iomanip>
#include <iostream>

const double radius = 1., half = 50., height = 0.2, modulus = 1000.,
             poisson_ratio = 0.3, compression = 0.05;

struct Pressed
{
  bool   converged  = true;
  double error      = 0.; /**< of the force */
  double missing    = 0.; /**< energy less work, over the work */
  double difference = 0.; /**< of the forces on both plates */
};



Pressed
press(const unsigned int n_elements,
      const unsigned int degree,
      const double       threshold)
{
  Scene scene;
  scene.fibers.element_kind           = Beam::ElementKind::director;
  scene.fibers.degree                 = degree;
  scene.fibers.material.axial_modulus = modulus;
  scene.fibers.material.poisson_ratio = poisson_ratio;
  scene.newton.residual_tolerance     = 1e-8;
  auto &first                         = scene.add_support();
  first.nodes.nodes                   = Contributions::ChosenNodes::first_end;
  first.displacement                  = {{"0", "0", "0"}};
  auto &last                          = scene.add_support();
  last.nodes.nodes                    = Contributions::ChosenNodes::last_end;
  last.displacement                   = {{"free", "0", "0"}};
  auto &all                           = scene.add_support();
  all.nodes.nodes                     = Contributions::ChosenNodes::all;
  all.displacement                    = {{"free", "0", "free"}};

  Textile::FiberPath path;
  const unsigned int n_knots = degree * n_elements + 1;
  for (unsigned int i = 0; i < n_knots; ++i)
    {
      const double x = 2. * half * i / (n_knots - 1);
      path.points.push_back(
        Tensor<1, 3>({x, 0., height * std::sin(numbers::PI * x / half)}));
      if (i > 0)
        path.reference_length += (path.points[i] - path.points[i - 1]).norm();
    }
  path.radius = radius;
  scene.build({path});

  Contributions::PlateParameters parameters;
  parameters.compression = std::to_string(compression) + "*t";
  const auto plates      = std::make_shared<Contributions::Plates>(
    *scene.space, parameters, threshold, std::nullopt);
  scene.contributions.push_back(plates);
  plates->begin_stage(*scene.state);

  Pressed result;
  for (const double t : {0.25, 0.5, 0.75, 1.})
    result.converged = scene.step(t).converged && result.converged;
  auto         values = scene.report();
  const double way    = 0.5 * compression * 2. * (height + radius);
  const double w = way - radius * values.at("max_plate_penetration_ratio[-]");
  const double inertia = numbers::PI / 4. * std::pow(radius, 4.);
  const auto  &section = scene.space->fiber(0).section;
  const double exact =
    48. * modulus * inertia * w / std::pow(half, 3.) /
    (1. + 12. * section.bending / (section.shear * half * half));
  result.error = values.at("plate_force[N]") / exact - 1.;

  double energy = -values.at("plate_hardening[N*mm]");
  for (const auto &value : values)
    if (value.first.find("_energy[") != std::string::npos)
      energy += value.second;
  result.missing = energy / values.at("external_work[N*mm]") - 1.;
  return result;
}



/** Print the error, and the order in what was refined by @p factor. */
void
report(const std::string &what,
       const Pressed     &pressed,
       const double       bound,
       const double       before,
       const double       factor)
{
  std::cout << what << ": error " << std::setprecision(3) << pressed.error
            << ", energy that is missing " << pressed.missing;
  if (before != 0.)
    std::cout << ", order "
              << std::log(std::abs(before / pressed.error)) / std::log(factor);
  std::cout << std::endl;
  deallog << what << ": converged " << pressed.converged << ", error below "
          << bound << ' ' << (std::abs(pressed.error) < bound)
          << ", energies balance " << (std::abs(pressed.missing) < 1e-3)
          << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  double  before = 0.;
  for (unsigned int k = 0; k < 3; ++k)
    {
      const unsigned int n_elements = 20 << k;
      const Pressed      pressed    = press(n_elements, 1, 1e-3);
      report("degree 1, " + std::to_string(n_elements) + " elements",
             pressed,
             0.02 / (1 << k),
             before,
             2.);
      before = pressed.error;
    }

  // Elements of degree 2 leave the width over which the crest is pressed, which
  // goes like the square root of the penetration.
  before = 0.;
  for (const double threshold : {1e-2, 1e-3, 1e-4})
    {
      const Pressed pressed = press(40, 2, threshold);
      report("degree 2, threshold " + std::to_string(threshold),
             pressed,
             0.02 * std::sqrt(threshold),
             before,
             10.);
      before = pressed.error;
    }
}
