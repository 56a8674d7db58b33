// Between points of a circle, away from the free ends, both interpolations
// leave it by a distance of fourth order; both meet every point.
#include <heddle/textile/interpolation.h>

#include <deal.II/base/numbers.h>

#include "../tests.h"

using namespace Heddle::Textile;



/** Largest distance from the circle over the middle half of an arc. */
double
error(const Interpolation interpolation, const unsigned int n)
{
  std::vector<Tensor<1, 3>> points;
  for (unsigned int i = 0; i <= n; ++i)
    {
      const double angle = numbers::PI * i / n;
      points.push_back(Tensor<1, 3>({std::cos(angle), std::sin(angle), 0.}));
    }
  const InterpolatedCurve curve(points, interpolation);

  double error = 0.;
  for (unsigned int k = 0; k <= 1000; ++k)
    error = std::max(
      error, std::abs(curve(curve.end() * (0.25 + 0.0005 * k)).norm() - 1.));
  const double chord = curve.end() / n;
  for (unsigned int i = 0; i <= n; ++i)
    AssertThrow((curve(i * chord) - points[i]).norm() < 1e-12,
                ExcInternalError());
  return error;
}



int
main()
{
  initlog();
  for (const auto interpolation :
       {Interpolation::spline, Interpolation::catmull_rom})
    {
      deallog << (interpolation == Interpolation::spline ? "spline"
                                                         : "Catmull-Rom")
              << ", order of the error:";
      for (const unsigned int n : {32, 64, 128})
        deallog << " "
                << std::log2(error(interpolation, n) /
                             error(interpolation, 2 * n));
      deallog << std::endl;
    }
}
