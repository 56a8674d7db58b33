// How far the forces of contacts would press elastic fibers into each other:
// the approach of Hertz, of contacts that cross and of those along lines, and
// when it is told.
#include <heddle/contact/elastic_approach.h>

#include "../contact/contact_scene.h"
#include "../tests.h"

#include <cmath>

using Heddle::Contact::PressedFiber;
using Heddle::Contributions::Indentation;

/** Of E = 1 and nu = 0.25, as contact scenes have it. */
constexpr double plane_modulus = 1. / (1. - 0.25 * 0.25);

/** Approach of crossing cylinders by other integrals, and by bisection. */
double
by_bisection(const double        force,
             const double        angle,
             const PressedFiber &a,
             const PressedFiber &b)
{
  const double u = 1. / a.radius, v = 1. / b.radius;
  const double sum = 0.5 * (u + v);
  const double difference =
    0.5 * std::sqrt(u * u + v * v + 2. * u * v * std::cos(2. * angle));
  const double wanted = (sum + difference) / (sum - difference);
  double       low = 1e-6, high = 1. - 1e-9;
  double       first = 0., second = 0.;
  for (unsigned int i = 0; i < 100; ++i)
    {
      const double k = std::sqrt(low * high), e = std::sqrt(1. - k * k);
      first              = std::comp_ellint_1(e);
      second             = std::comp_ellint_2(e);
      const double found = (second / (k * k) - first) / (first - second);
      (found > wanted ? low : high) = k;
    }
  const double stiffness = 1. / (1. / a.plane_modulus + 1. / b.plane_modulus);
  const double half_axis = std::cbrt(
    3. * force * second / (2. * numbers::PI * stiffness * low * low * sum));
  return 3. * force * first / (2. * numbers::PI * half_axis * stiffness);
}



/**
 * Crossing fibers against the closed form at a right angle, and against other
 * ways to compute the integrals at others, of different fibers as well; so
 * does it grow with the force to the power 2/3. Parallel ones against numbers
 * that were computed by hand: R = 1, E* = 1/2 and p = pi / 400 make w = 0.1,
 * 2 ln 40 - 1 = 6.377759 and the approach p / pi times that, twice.
 */
void
formulas()
{
  const PressedFiber equal = {1., 1.}, thin = {0.3, 4.};
  const double       closed = std::cbrt(9. * 1e-6 / (16. * 0.25));
  deallog << "right angle, over the closed form: "
          << Heddle::Contact::crossing_approach(
               1e-3, 0.5 * numbers::PI, equal, equal) /
               closed
          << std::endl;
  for (const double degrees : {90., 60., 30., 10., 1.})
    {
      const double angle = degrees * numbers::PI / 180.;
      deallog << degrees << " degrees: ";
      for (const PressedFiber &other : {equal, thin})
        deallog << Heddle::Contact::crossing_approach(
                     1e-3, angle, equal, other) /
                     by_bisection(1e-3, angle, equal, other)
                << ", ";
      deallog << "of eight times the force over four times: "
              << Heddle::Contact::crossing_approach(8e-3, angle, equal, thin) /
                   (4. * Heddle::Contact::crossing_approach(
                           1e-3, angle, equal, thin))
              << std::endl;
    }
  deallog << "line: "
          << Heddle::Contact::line_approach(numbers::PI / 400., equal, equal) /
               (0.005 * 6.377759)
          << ", no force " << Heddle::Contact::line_approach(0., equal, equal)
          << ", more for more force: "
          << (Heddle::Contact::line_approach(2., equal, equal) >
              Heddle::Contact::line_approach(1.9, equal, equal))
          << std::endl;
}



/** Put fibers on these paths in contact and return what is found. */
Indentation
found(const std::vector<Path>         &paths,
      const std::vector<unsigned int> &n_intervals,
      double                          &total_force)
{
  // Penalties grow fourfold until contacts are harder than fibers.
  ContactScene::Options options;
  options.threshold = 0.001;
  ContactScene scene(paths, n_intervals, options);
  scene.forces(/*search=*/true);
  for (unsigned int i = 0; i < 4; ++i)
    {
      scene.contact->adapt(scene.state);
      scene.forces();
    }
  scene.contact->accept_step(scene.state);
  total_force = scene.reported("mean_contact_force[N]") *
                scene.reported("active_contact_elements[-]");
  return scene.contact->indentation();
}



void
print(const std::string &name,
      const Indentation &indentation,
      const double       expected_force,
      const double       expected_approach,
      const double       penetration,
      const double       total_force)
{
  deallog << name << ": fibers " << indentation.fiber_a << " and "
          << indentation.fiber_b << ", a line: " << indentation.is_line
          << ", force over that of the contact "
          << indentation.force / expected_force << ", approach over Hertz' "
          << indentation.ratio / expected_approach
          << ", work over force times what is missing "
          << indentation.work /
               (total_force * (expected_approach - penetration))
          << std::endl;
}



/**
 * Two straight fibers, pressed into each other by a given penetration: a
 * crossing has the whole force, fibers side by side that per length. One that
 * winds around another one is a line, at whatever angle. A third fiber beside
 * them is not touched.
 */
void
contacts()
{
  deallog << std::setprecision(3);
  constexpr double   length = 40., penetration = 0.01;
  const PressedFiber one = {1., plane_modulus};
  const Path         other =
    line(Tensor<1, 3>({0., 0., 30.}), Tensor<1, 3>({1., 0., 0.}), length);
  const Tensor<1, 3> x({1., 0., 0.}), height({0., 0., 2. - penetration});
  for (const double degrees : {90., 60., 20., 5.})
    {
      const double       angle = degrees * numbers::PI / 180.;
      const Tensor<1, 3> d({std::cos(angle), std::sin(angle), 0.});
      double             force;
      const Indentation  indentation = found(
        {other, line(-20. * x, x, length), line(height - 20. * d, d, length)},
        {12, 12, 12},
        force);
      print(std::to_string(std::lround(degrees)) + " degrees",
            indentation,
            force,
            Heddle::Contact::crossing_approach(force, angle, one, one),
            penetration,
            force);
    }
  double            force;
  const Indentation beside =
    found({line(-20. * x, x, length), line(height - 20. * x, x, length), other},
          {12, 12, 12},
          force);
  print("side by side",
        beside,
        force / length,
        Heddle::Contact::line_approach(force / length, one, one),
        penetration,
        force);

  const auto helix = [&](const double phase) -> Path {
    return [=](const double t) {
      const double angle = 4. * numbers::PI * t + phase;
      return Tensor<1, 3>({(1. - 0.5 * penetration) * std::cos(angle),
                           (1. - 0.5 * penetration) * std::sin(angle),
                           24. * t});
    };
  };
  const Indentation wound =
    found({helix(0.), helix(numbers::PI)}, {48, 48}, force);
  deallog << "wound: a line: " << wound.is_line << ", approach over Hertz' "
          << wound.ratio / Heddle::Contact::line_approach(wound.force, one, one)
          << std::endl;
}



/** Forces are too large by the root of an equation; told are large ones. */
void
told()
{
  for (const double r : {0.5, 1.01, 2.8, 100.})
    for (const double threshold : {0.02, 0.2})
      {
        Indentation indentation;
        indentation.fiber_a  = 3;
        indentation.fiber_b  = 7;
        indentation.position = Point<3>(1., 2., 3.);
        indentation.force    = 0.5;
        indentation.ratio    = 0.35;
        indentation.allowed  = threshold;
        indentation.work     = 2. * r;
        indentation.energy   = 1.;
        const double y       = 1. / indentation.excess_of_force();
        deallog << std::setprecision(3) << "r = " << r << ": y " << y
                << ", solved: "
                << (std::abs(y + r * std::pow(y, 2. / 3.) - 1.) < 1e-12)
                << ", told at " << threshold << ": '" << indentation.in_words()
                << "'" << std::endl;
      }
  deallog << "nothing at all: '" << Indentation().in_words() << "'"
          << std::endl;
}



int
main(int argc, char **argv)
{
  const MPITest mpi(argc, argv);
  run_part("Formulas", formulas);
  run_part("Contacts", contacts);
  run_part("Told", told);
}
