// An end moment rolls a straight cantilever of unit length up to a full circle,
// in 16 steps of at most 6 iterations each; to half a circle, 4 steps of at
// most 11 will do. Beyond, steps of 45 degrees take 11 to 40 iterations in no
// order. Errors of the tip in units of 1e-6 L. The radius of the fiber times
// its curvature reaches 0.0031.
#include "single_fiber.h"

/** What happened on the way to an angle of the tip. */
struct Result
{
  double       error      = 0.;
  unsigned int iterations = 0;
};



/** Roll up to @p angle and return the error there and the largest count. */
Result
roll_up(const Kind        &kind,
        const unsigned int n_elements,
        const double       angle,
        const unsigned int n_steps)
{
  const auto  section = Heddle::Beam::circular_section(.5e-3, 1., 1. / 2.6, .3);
  SingleFiber fiber(kind, section, straight_line, /*length=*/1., n_elements);
  fiber.release_stretch();
  Result result;
  for (unsigned int step = 1; step <= n_steps; ++step)
    {
      const double moment = section.bending * angle * step / n_steps;
      result.iterations =
        std::max(result.iterations,
                 fiber.solve(Tensor<1, 3>(), Tensor<1, 3>({0., 0., moment})));
    }
  const Tensor<1, 3> tip(
    {std::sin(angle) / angle, (1. - std::cos(angle)) / angle, 0.});
  result.error = (fiber.tip() - tip).norm();
  return result;
}



void
test(const Kind &kind, const unsigned int coarsest, const double allowed)
{
  double before = 0.;
  for (unsigned int n = coarsest; n <= 4 * coarsest; n *= 2)
    {
      const Result half = roll_up(kind, n, M_PI, /*n_steps=*/4);
      const Result full = roll_up(kind, n, 2. * M_PI, /*n_steps=*/16);
      deallog << kind.name << ' ' << kind.degree << ", elements " << n
              << ": at 180 degrees error " << micro(half.error)
              << ", iterations " << half.iterations << ", at 360 error "
              << micro(full.error) << ", iterations " << full.iterations;
      if (before > 0. && full.error > 2e-5)
        deallog << ", order " << order(before, full.error);
      deallog << verdict(half.iterations <= 11 && full.iterations <= 6 &&
                         (n < 4 * coarsest || full.error < allowed))
              << std::endl;
      before = full.error;
    }
}



int
main()
{
  initlog();
  test({"hermite", 3}, /*coarsest=*/8, /*allowed=*/2e-5);
  test({"director", 1}, /*coarsest=*/16, /*allowed=*/5e-3);
  test({"director", 2}, /*coarsest=*/8, /*allowed=*/2e-5);
  test({"director", 3}, /*coarsest=*/4, /*allowed=*/2e-5);
}
