// A fiber of length L in a matrix of the prescribed strain e takes up
// e (1 - cosh(bs) / cosh(bL/2)) at the distance s from its middle, b^2 = E_m /
// EA: what is missing falls from its end on over 1/b = R sqrt(pi E_f / E_m),
// 17.7 R for a ratio of 100 and 56.0 R for 1000. The slender element bends when
// its strain changes: there b^2 (1 - (bR/2)^2) = E_m / EA.
// Errors and orders are printed to the screen; compared are bounds.
#include "composite.h"

constexpr double radius = 0.1;



/** The length 1/b with so many elements on it [mm]. */
double
transfer_length(const std::string &element,
                const double       ratio,
                const unsigned int n_per_length)
{
  constexpr double   strain     = 1e-6;
  const double       rough      = radius * std::sqrt(numbers::PI * ratio);
  const double       length     = 16. * rough;
  const unsigned int n_elements = 16 * n_per_length;
  Composite          scene(mesh(n_elements, 1, Tensor<1, 3>({length, 4., 4.})) +
                  " set Coupling points per element = 2\n");
  scene.fibers.element_name                                     = element;
  scene.fibers.material.axial_modulus                           = ratio;
  scene.fibers.material.poisson_ratio                           = 0.;
  scene.hold({"x-", "x+", "y-", "y+", "z-", "z+"}).displacement = {
    {"1e-6*x", "0", "0"}};
  // Nothing else keeps the fiber from turning about its axis.
  auto &held       = scene.add_support();
  held.nodes.nodes = "first end";
  held.section     = "held";
  scene.embed({straight_path(Tensor<1, 3>({0., 2., 2.}),
                             Tensor<1, 3>({length, 2., 2.}),
                             n_elements + 1,
                             radius)});
  scene.newton.residual_tolerance  = 1e-9;
  scene.newton.increment_tolerance = 1e-9;
  scene.step(1.);

  // The length is that between the middles of two elements, half and two such
  // lengths from the end, over the logarithm of what it changes. The other end
  // is too far to count.
  const auto missing = [&](const unsigned int i) {
    const double stretch =
      (scene.block(0, i + 1)[0] - scene.block(0, i)[0]) * n_elements / length;
    return 1. - (stretch - 1.) / strain;
  };
  const unsigned int begin = n_per_length / 2, end = 2 * n_per_length;
  const double       distance = (end - begin) * length / n_elements;
  return distance / std::log(missing(begin) / missing(end));
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  for (const std::string element : {"hermite", "director"})
    for (const double ratio : {100., 1000.})
      {
        const std::string what =
          element + ", ratio " + Utilities::to_string(int(ratio));
        double exact = radius * std::sqrt(numbers::PI * ratio);
        if (element == "hermite")
          exact =
            radius *
            std::sqrt(0.5 / (1. - std::sqrt(1. - std::pow(radius / exact, 2))));
        double coarse = 0., fine = 0.;
        for (const unsigned int n : {2, 4, 8, 16})
          {
            coarse              = fine;
            const double length = transfer_length(element, ratio, n);
            fine                = std::abs(length / exact - 1.);
            print(what + ", length in radii", n, length / radius);
            print(what + ", error", n, fine);
          }
        const double order = std::log2(coarse / fine);
        print(what + ", order", 16, order);
        deallog << what << ": 0.02 % " << (fine < 2e-4)
                << ", order at least 1.9 " << (order > 1.9 || fine < 1e-5)
                << std::endl;
      }
}
