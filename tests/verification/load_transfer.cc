// A fiber of length L in a matrix of the prescribed strain e takes up
// e (1 - cosh(bs) / cosh(bL/2)) at the distance s from its middle, b^2 = E_m /
// EA: what is missing falls from its end on over 1/b = R sqrt(pi E_f / E_m),
// 17.7 R for a ratio of 100 and 56.0 R for 1000. The slender element bends when
// its strain changes: there b^2 (1 - (bR/2)^2) = E_m / EA.
//
// A fiber that leaves a rigid matrix by a is pulled by F at its end by
// F / sqrt(k EA) / tanh(bL) + F a / EA, and across, as a beam on springs with
// beta^4 = k / 4EI, by w + theta a + F a^3 / 3EI, where w = 2 beta (F + beta F
// a) / k and theta = 2 beta^2 (F + 2 beta F a) / k (M. Hetenyi 1946): wherever
// its nodes lie. Errors and orders are printed to the screen; compared are
// bounds.
#include <heddle/base/choice.h>

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
  scene.fibers.element_kind =
    Heddle::choice<Heddle::Beam::ElementKind>(element);
  scene.fibers.material.axial_modulus                           = ratio;
  scene.fibers.material.poisson_ratio                           = 0.;
  scene.hold({"x-", "x+", "y-", "y+", "z-", "z+"}).displacement = {
    {"1e-6*x", "0", "0"}};
  // Nothing else keeps the fiber from turning about its axis.
  auto &held       = scene.add_support();
  held.nodes.nodes = Heddle::Contributions::ChosenNodes::first_end;
  held.section     = Heddle::Contributions::SupportedSection::held;
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



/**
 * Worst errors of the motion of the end, along and across, relative, with
 * elements of 1/n mm. Nodes lie on the surface, just outside, half way, and
 * just within.
 */
std::pair<double, double>
pulled_out(const std::string &element, const unsigned int n)
{
  constexpr double modulus = 1e5, k = 100., along = 1e-3, across = 1e-6;
  const double     EA          = modulus * numbers::PI * radius * radius;
  const double     EI          = 0.25 * EA * radius * radius;
  double           worst_along = 0., worst_across = 0.;
  for (const double offset : {0., 0.02 / n, 0.5 / n, 0.98 / n})
    {
      Composite scene(mesh(20, 1, Tensor<1, 3>({20., 1., 1.})) +
                      " set Youngs modulus = 100\n");
      scene.fibers.element_kind =
        Heddle::choice<Heddle::Beam::ElementKind>(element);
      scene.fibers.material.axial_modulus                           = modulus;
      scene.fibers.material.poisson_ratio                           = 0.;
      scene.hold({"x-", "x+", "y-", "y+", "z-", "z+"}).displacement = {
        {"0", "0", "0"}};
      // Nothing else keeps the fiber from turning about its axis.
      auto &held       = scene.add_support();
      held.nodes.nodes = Heddle::Contributions::ChosenNodes::first_end;
      held.section     = Heddle::Contributions::SupportedSection::held;
      auto &load       = scene.add_load();
      load.nodes.nodes = Heddle::Contributions::ChosenNodes::last_end;
      load.force       = {
              {std::to_string(along), "0", "0.001*" + std::to_string(along)}};
      scene.embed({straight_path(Tensor<1, 3>({offset, 0.5, 0.5}),
                                 Tensor<1, 3>({21. + offset, 0.5, 0.5}),
                                 21 * n + 1,
                                 radius)});
      scene.newton.residual_tolerance  = 1e-9;
      scene.newton.increment_tolerance = 1e-9;
      scene.step(1.);

      const double a = 1. + offset, b = std::sqrt(k / EA),
                   beta = std::pow(k / (4. * EI), 0.25);
      const double u =
        along *
        (1. / (std::sqrt(k * EA) * std::tanh(b * (20. - offset))) + a / EA);
      const double w =
        across * (2. * beta / k * (1. + beta * a) +
                  2. * beta * beta / k * (1. + 2. * beta * a) * a +
                  a * a * a / (3. * EI));
      const Tensor<1, 3> end = scene.block(0, scene.last_node());
      worst_along =
        std::max(worst_along, std::abs((end[0] - 21. - offset) / u - 1.));
      worst_across = std::max(worst_across, std::abs((end[2] - 0.5) / w - 1.));
    }
  return {worst_along, worst_across};
}



/**
 * Errors as bounds. The slender element bends when its strain changes: along
 * it, u is off by (bR/2)^2 / 2, 4e-5. The other one shears, which w leaves out.
 */
void
leave_matrix(const std::string &element)
{
  const std::string         what   = element + " that leaves the matrix";
  std::pair<double, double> coarse = {0., 0.}, fine = {0., 0.};
  for (const unsigned int n : {2, 4, 8})
    {
      coarse = fine;
      fine   = pulled_out(element, n);
      print(what + ", along", n, fine.first);
      print(what + ", across", n, fine.second);
    }
  const double along  = std::log2(coarse.first / fine.first),
               across = std::log2(coarse.second / fine.second);
  print(what + ", orders, along", 8, along);
  print(what + ", orders, across", 8, across);
  deallog << what << ", along: 0.02 % " << (fine.first < 2e-4)
          << ", order at least 1.8 " << (along > 1.8 || fine.first < 1.2e-4);
  if (element == "hermite")
    deallog << ", across: 2 % " << (fine.second < 0.02)
            << ", order at least 1.8 " << (across > 1.8);
  deallog << std::endl;
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
  for (const std::string element : {"hermite", "director"})
    leave_matrix(element);
}
