// An end moment rolls a straight cantilever of unit length up to a full circle,
// in steps of 45 degrees. Errors of the tip in units of 1e-6 L. The radius of
// the fiber times its curvature reaches 0.0031.
#include "single_fiber.h"

void
test(const Kind &kind, const unsigned int coarsest, const double allowed)
{
  const auto section = Heddle::Beam::circular_section(.5e-3, 1., 1. / 2.6, .3);
  double     before  = 0.;
  for (unsigned int n = coarsest; n <= 4 * coarsest; n *= 2)
    {
      SingleFiber fiber(kind, section, straight_line, /*length=*/1., n);
      fiber.release_stretch();
      bool   equilibrium = true;
      double quarter     = 0.;
      double error       = 0.;
      for (unsigned int step = 1; step <= 8; ++step)
        {
          const double       angle = .25 * M_PI * step;
          const Tensor<1, 3> moment({0., 0., angle * section.bending});
          equilibrium =
            fiber.solve(Tensor<1, 3>(), moment) <= 60 && equilibrium;
          const Tensor<1, 3> tip(
            {std::sin(angle) / angle, (1. - std::cos(angle)) / angle, 0.});
          error = (fiber.tip() - tip).norm();
          if (step == 2)
            quarter = error;
        }
      deallog << kind.name << ' ' << kind.degree << ", elements " << n
              << ": error at 90 degrees " << micro(quarter) << ", at 360 "
              << micro(error);
      if (before > 0.)
        deallog << ", order " << order(before, error);
      deallog << verdict(equilibrium && (n < 4 * coarsest || error < allowed))
              << std::endl;
      before = error;
    }
}



int
main()
{
  initlog();
  test({"hermite", 3}, /*coarsest=*/8, /*allowed=*/5e-5);
  test({"director", 1}, /*coarsest=*/16, /*allowed=*/5e-2);
  test({"director", 2}, /*coarsest=*/8, /*allowed=*/5e-4);
  test({"director", 3}, /*coarsest=*/4, /*allowed=*/5e-5);
}
