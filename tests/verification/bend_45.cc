// The 45-degree bend of Bathe and Bolourchi (1979): a clamped arc of radius 100
// and section 1 x 1 under a force out of its plane. The reference is the exact
// rod with the torsion constant 1/6 of a section that stays plane, known to
// three decimals. Errors of the tip relative to the radius, in units of 1e-6;
// the rod differs from the body by the square of thickness over radius, of the
// order of 25 of these.
#include "single_fiber.h"

constexpr double radius = 100.;



Frame
arc(const double s)
{
  const double angle  = s / radius;
  const double cosine = std::cos(angle), sine = std::sin(angle);
  return {Tensor<1, 3>({radius * sine, radius * (1. - cosine), 0.}),
          Tensor<1, 3>({cosine, sine, 0.}),
          Tensor<1, 3>({-sine, cosine, 0.}),
          Tensor<1, 3>({0., 0., 1.})};
}



/** E = 1e7, no contraction. */
Heddle::Beam::Section
square_section()
{
  Heddle::Beam::Section section;
  section.axial     = 1e7;
  section.bending   = 1e7 / 12.;
  section.torsion   = 5e6 / 6.;
  section.shear     = 5e6;
  section.thickness = 5e6;
  section.gradient  = 5e6 / 12.;
  return section;
}



void
test(const Kind &kind, const unsigned int coarsest, const double allowed)
{
  const std::array<double, 3>       loads = {{300., 450., 600.}};
  const std::array<Tensor<1, 3>, 3> tips  = {
     {Tensor<1, 3>({58.779, 22.245, 40.192}),
      Tensor<1, 3>({52.239, 18.508, 48.503}),
      Tensor<1, 3>({47.150, 15.685, 53.475})}};

  double before = 0.;
  for (unsigned int n = coarsest; n <= 4 * coarsest; n *= 2)
    {
      SingleFiber fiber(kind, square_section(), arc, .25 * M_PI * radius, n);
      deallog << kind.name << ' ' << kind.degree << ", elements " << n << ':';
      double error = 0.;
      for (unsigned int i = 0; i < loads.size(); ++i)
        {
          const unsigned int iterations =
            fiber.solve(Tensor<1, 3>({0., 0., loads[i]}));
          error = (fiber.tip() - tips[i]).norm() / radius;
          deallog << " P " << loads[i] << " error " << micro(error)
                  << " iterations " << iterations << ',';
        }
      if (before > 0. && error > 1e-4)
        deallog << " order " << order(before, error);
      deallog << verdict(n < 4 * coarsest || error < allowed) << std::endl;
      before = error;
    }
}



int
main()
{
  initlog();
  test({"director", 1}, /*coarsest=*/8, /*allowed=*/1e-3);
  test({"director", 2}, /*coarsest=*/4, /*allowed=*/1e-4);
  test({"director", 3}, /*coarsest=*/2, /*allowed=*/1e-4);
}
