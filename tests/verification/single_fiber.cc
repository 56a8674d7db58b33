// What a fiber answers: in few iterations, without locking, and whatever the
// path to the load.
#include "single_fiber.h"

/**
 * A cantilever of unit length under the tip force P L^2 / EI = 10 in one load
 * step: Newton with mixed integration points needs at most 9 iterations,
 * counted until the increment is below 1e-8 of the length, whatever the
 * slenderness.
 */
void
newton_iterations()
{
  for (const Kind &kind : all_elements)
    for (const double slenderness : {10., 100., 1000., 10000.})
      {
        const auto section =
          Heddle::Beam::circular_section(.5 / slenderness, 1., 1. / 2.6, .3);
        SingleFiber fiber(kind,
                          section,
                          straight_line,
                          /*length=*/1.,
                          /*n_elements=*/16);
        fiber.release_stretch();
        const unsigned int n =
          fiber.solve(Tensor<1, 3>({0., 10. * section.bending, 0.}));
        deallog << kind.name << ' ' << kind.degree << ", slenderness "
                << slenderness << ": iterations " << n << verdict(n <= 9)
                << std::endl;
      }
}



/** Deflection over that of the linear theory, under a load for 1e-3 L. */
double
ratio(const Kind &kind, const double slenderness, const double nu)
{
  const double shear_modulus = 1. / (2. * (1. + nu));
  const auto   section =
    Heddle::Beam::circular_section(.5 / slenderness, 1., shear_modulus, nu);
  SingleFiber fiber(
    kind, section, straight_line, /*length=*/1., /*n_elements=*/16);
  fiber.release_stretch();
  const double force = 3e-3 * section.bending;
  fiber.solve(Tensor<1, 3>({0., force, 0.}));
  return fiber.tip()[1] /
         (force / (3. * section.bending) +
          (kind.name == "director" ? force / section.shear : 0.));
}



/**
 * Nothing locks: the tip deflection of a cantilever of 16 elements over P L^3 /
 * 3 EI + P L / GA, the second term for elements that shear, does not depend on
 * the slenderness from 10 to 10^4, nor on Poisson's ratio from 0 to 0.49.
 */
void
locking()
{
  for (const Kind &kind : all_elements)
    {
      // Linear elements miss 1 / (4 n^2) of the bending.
      const double expected = kind.degree == 1 ? 1. - 1. / 1024. : 1.;
      for (const double slenderness : {10., 100., 1000., 10000.})
        {
          const double found = ratio(kind, slenderness, .3);
          deallog << kind.name << ' ' << kind.degree << ", slenderness "
                  << slenderness << ": deflection / theory "
                  << significant(found, 5)
                  << verdict(std::abs(found - expected) < 1e-4) << std::endl;
        }
      for (const double nu : {0., .1, .2, .3, .4, .45, .49})
        {
          const double found = ratio(kind, 100., nu);
          deallog << kind.name << ' ' << kind.degree << ", nu " << nu
                  << ": deflection / theory " << significant(found, 5)
                  << verdict(std::abs(found - expected) < 1e-4) << std::endl;
        }
    }
}



const auto path_section =
  Heddle::Beam::circular_section(/*radius=*/.01, 1., 1. / 2.6, .3);

/** A force out of every plane of symmetry. */
const Tensor<1, 3> force = Tensor<1, 3>({-.5, 2., 3.}) * path_section.bending;



/** A third of a circle, so that the force twists it as well. */
Frame
arc(const double s)
{
  const double turn = 2. * M_PI / 3.;
  const double c = std::cos(turn * s), d = std::sin(turn * s);
  return {Tensor<1, 3>({d / turn, (1. - c) / turn, 0.}),
          Tensor<1, 3>({c, d, 0.}),
          Tensor<1, 3>({-d, c, 0.}),
          Tensor<1, 3>({0., 0., 1.})};
}



/** Straight for the Hermite element, which has no torsion to hold an arc. */
SingleFiber
make_fiber(const Kind &kind)
{
  return SingleFiber(kind,
                     path_section,
                     kind.name == "hermite" ? straight_line : arc,
                     /*length=*/1.,
                     /*n_elements=*/8);
}



Tensor<1, 3>
turned(const Tensor<1, 3> &x, const double angle)
{
  const double c = std::cos(angle), d = std::sin(angle);
  return Tensor<1, 3>({c * x[0] - d * x[2], x[1], d * x[0] + c * x[2]});
}



/** Turn the clamp and the force; the rest of the fiber has to follow. */
void
carry_around(SingleFiber &fiber, const unsigned int n_clamped)
{
  const double       energy = fiber.energy();
  const Tensor<1, 3> tip    = fiber.tip();
  double             change = 0.;
  unsigned int       most   = 0;
  for (unsigned int step = 1; step <= 12; ++step)
    {
      for (unsigned int b = 0; b < n_clamped; ++b)
        fiber.blocks[b] = turned(fiber.blocks[b], M_PI / 6.);
      most   = std::max(most, fiber.solve(turned(force, step * M_PI / 6.)));
      change = std::max(change, std::abs(fiber.energy() / energy - 1.));
    }
  const double error = (fiber.tip() - tip).norm();
  deallog << ", turned: energy kept " << (change < 1e-6) << ", tip back "
          << (error < 1e-7) << ", most iterations " << most
          << verdict(change < 1e-6 && error < 1e-7);
}



/**
 * What a fiber answers depends on where it is, not on how it came there: the
 * same load in two or in six steps gives the same tip; back without load, no
 * energy is left; carried once around in steps of 30 degrees under a force that
 * turns along, the loaded fiber keeps its energy and comes back to its place.
 */
void
independence_of_paths()
{
  for (const Kind &kind : all_elements)
    {
      SingleFiber two = make_fiber(kind), six = make_fiber(kind);
      for (unsigned int step = 1; step <= 2; ++step)
        two.solve(step / 2. * force);
      for (unsigned int step = 1; step <= 6; ++step)
        six.solve(step / 6. * force);
      const double distance = (two.tip() - six.tip()).norm();
      const double loaded   = two.energy();
      deallog << kind.name << ' ' << kind.degree << ": same tip "
              << (distance < 1e-8) << verdict(distance < 1e-8);

      carry_around(six, kind.name == "hermite" ? 2 : 3);

      two.solve(.5 * force);
      two.solve(Tensor<1, 3>());
      deallog << ", unloaded: energy left " << (two.energy() > 1e-12 * loaded)
              << verdict(two.energy() < 1e-12 * loaded) << std::endl;
    }
}



int
main()
{
  initlog();
  run_part("Newton iterations", newton_iterations);
  run_part("Locking", locking);
  run_part("Paths", independence_of_paths);
}
