// For an isotropic fiber the law of axial strain and section stretch is the
// three-dimensional one. A section that is free to stretch contracts by
// Poisson's ratio, with exactly EA, also where E and G are independent.
#include "random_element.h"



/** Energy of a fiber of length 1 with the given strains. */
double
energy(const Heddle::Beam::Section &section,
       const double                 axial,
       const double                 first,
       const double                 second)
{
  const auto stretch = [](const double strain) {
    return std::sqrt(1. + 2. * strain);
  };
  std::vector<Tensor<1, 3>> blocks(6);
  blocks[3][0] = stretch(axial);
  blocks[1][1] = blocks[4][1] = stretch(first);
  blocks[2][2] = blocks[5][2] = stretch(second);
  const std::vector<double> reference(12, 0.);
  return Heddle::Beam::make_element("director", 1)
    ->assemble(section,
               blocks.data(),
               /*length=*/1.,
               reference.data(),
               /*predicted_stresses=*/nullptr,
               /*residual=*/nullptr,
               /*tangent=*/nullptr);
}



int
main()
{
  initlog();
  const double radius = .7;
  const double area   = M_PI * radius * radius;
  const double e = .03, e1 = -.02, e2 = .05;
  for (const double nu : {0., .3, .49})
    {
      const double shear  = 1. / (2. * (1. + nu));
      const double lambda = 2. * shear * nu / (1. - 2. * nu);
      const double exact  = .5 * area *
                           (lambda * std::pow(e + e1 + e2, 2) +
                            2. * shear * (e * e + e1 * e1 + e2 * e2));
      deallog << "isotropic, nu " << nu << ": energy / exact "
              << rounded(
                   energy(Heddle::Beam::circular_section(radius, 1., shear, nu),
                          e,
                          e1,
                          e2) /
                     exact,
                   5)
              << std::endl;
    }

  for (const double shear : {.02, .06, .4})
    for (const double nu : {0., .3, .49})
      {
        const auto section =
          Heddle::Beam::circular_section(radius, 1., shear, nu);
        const auto at = [&](const double d1, const double d2) {
          return energy(section, e, -nu * e + d1, -nu * e + d2);
        };
        const double d = 1e-3;
        deallog << "G/E " << shear << ", nu " << nu << ": energy / (EA/2 e^2) "
                << rounded(at(0., 0.) / (.5 * area * e * e), 5)
                << ", least energy "
                << (at(0., 0.) < std::min({at(d, 0.),
                                           at(-d, 0.),
                                           at(0., d),
                                           at(0., -d),
                                           at(d, -d),
                                           at(d, d)}))
                << std::endl;
      }
}
