// Nothing locks: the tip deflection of a cantilever of 16 elements over
// P L^3 / 3 EI + P L / GA, the second term for elements that shear, does not
// depend on the slenderness from 10 to 10^4, nor on Poisson's ratio from 0 to
// 0.49.
#include "single_fiber.h"

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



int
main()
{
  initlog();
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
