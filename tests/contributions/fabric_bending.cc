// Where the sides of a fabric go that is bent to a cylinder: the formulas of
// supports are the motion that is measured by, which keeps lengths in the
// neutral surface and right angles to it. What is bent is flattened again. Its
// derivative by the curvature is compared with differences, of order 2.
#include <heddle/contributions/fabric_bending.h>

#include "../contact/knots.h"
#include "../tests.h"

#include <cmath>

using Heddle::Expression;
using Heddle::Contributions::FabricBending;

/** The ramp, and load factors of which the first leaves the fabric flat. */
const std::string           ramp         = "t*(2-t)";
const std::array<double, 4> load_factors = {{0., 1e-3, 0.4, 1.}};



/** The largest difference of the formulas from the motion [mm]. */
double
difference(const FabricBending &bending, RandomNumbers &random)
{
  double     largest  = 0.;
  const auto formulas = bending.displacement();
  for (unsigned int i = 0; i < 100; ++i)
    {
      const Tensor<1, 3> place = random.direction();
      for (const double t : load_factors)
        {
          const Tensor<1, 3> expected = bending.displacement(place, t);
          for (unsigned int d = 0; d < 3; ++d)
            largest = std::max(
              largest,
              std::abs(Expression(formulas[d], "test").value(place, t) -
                       expected[d]));
          // What is ahead along the yarns is lifted by as much as they turn.
          const double angle =
            Expression(bending.turn_angle(), "test").value(place, t);
          largest = std::max(
            largest, std::abs(std::sin(angle) - bending.tangent(place, t)[2]));
        }
    }
  return largest;
}



/** What the motion makes of a unit vector at a place of the neutral surface. */
Tensor<1, 3>
image(const FabricBending &bending, const unsigned int component)
{
  const double       step = 1e-5;
  const Tensor<1, 3> place({0.3, 0.3, 0.});
  Tensor<1, 3>       unit;
  unit[component] = 1.;
  return unit + (bending.displacement(place + step * unit, 1.) -
                 bending.displacement(place - step * unit, 1.)) /
                  (2. * step);
}



/** The largest error of places that are bent and flattened again [mm]. */
double
error_of_flattening(const FabricBending &bending, RandomNumbers &random)
{
  double largest = 0.;
  for (unsigned int i = 0; i < 100; ++i)
    {
      // Turned by up to 175 degrees, and less than the radius off the surface.
      Tensor<1, 3> place = 1.8 * random.direction();
      place[2] *= 0.3;
      for (const double t : load_factors)
        largest = std::max(
          largest,
          (bending.flattened(place + bending.displacement(place, t), t) - place)
            .norm());
    }
  return largest;
}



/** Stretches are 1, and right angles stay. */
void
lengths(const FabricBending &bending)
{
  double error = 0.;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      error = std::max(
        error,
        std::abs(image(bending, i) * image(bending, j) - (i == j ? 1. : 0.)));
  const Tensor<1, 3> tangent =
    bending.tangent(Tensor<1, 3>({0.3, 0.3, 0.}), 1.);
  error =
    std::max(error, (image(bending, bending.direction()) - tangent).norm());
  deallog << "lengths and angles are kept " << (error < 1e-8) << std::endl;
}



/** What a difference by the curvature misses of the rate. */
double
error_of_rate(const double        curvature,
              const double        step,
              const Tensor<1, 3> &place)
{
  const auto at = [&](const double k) {
    return FabricBending(0, k, "t").displacement(place, 1.);
  };
  return ((at(curvature + step) - at(curvature - step)) / (2. * step) -
          FabricBending(0, curvature, "t").displacement_rate(place, 1.))
    .norm();
}



void
rates()
{
  RandomNumbers         random(1);
  std::array<double, 3> errors = {};
  for (unsigned int i = 0; i < 200; ++i)
    {
      // From far bent to where series take over.
      const double       curvature = std::pow(10., random.between(-5., 0.));
      const Tensor<1, 3> place     = random.direction();
      for (unsigned int k = 0; k < errors.size(); ++k)
        errors[k] += error_of_rate(curvature, 0.04 / (1u << k), place);
    }
  deallog << "order "
          << std::round(10. * std::log2(errors[0] / errors[1])) / 10. << ", "
          << std::round(10. * std::log2(errors[1] / errors[2])) / 10.
          << std::endl;
  std::cout << "observed order " << std::log2(errors[0] / errors[1]) << ", "
            << std::log2(errors[1] / errors[2]) << std::endl;
}



int
main(int argc, char **argv)
{
  const MPITest mpi(argc, argv);
  for (const unsigned int direction : {0, 1})
    {
      const FabricBending bending(direction, -1.7, ramp);
      RandomNumbers       random(2);
      deallog << "formulas are the motion "
              << (difference(bending, random) < 1e-13) << std::endl;
      lengths(bending);
      deallog << "flattened again "
              << (error_of_flattening(bending, random) < 1e-13) << std::endl;
    }
  rates();
}
