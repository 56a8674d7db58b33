// The section of a fiber that is bent to the curvature kappa flattens until
// g_1^2 = 1 - (1 - nu) E / S (kappa R / 2)^2, where S resists it: found by
// Newton's method on one element of an arc, at several angles of it. A fiber
// that is soft in shear flattens no more than an isotropic one.
#include "random_element.h"

#include <iomanip>
#include <sstream>

using namespace Heddle;

constexpr double radius = 1., kappa = .4;



/** Equilibrium of the stretches of both section vectors; return the first. */
double
stretch(const Beam::Section &section, const unsigned int degree, double angle)
{
  const auto   element = Beam::make_element("director", degree);
  const double length  = angle / kappa;
  const auto   blocks  = [&](const double first, const double second) {
    std::vector<Tensor<1, 3>> result;
    for (unsigned int node = 0; node <= degree; ++node)
      {
        const double       phi = (double(node) / degree - .5) * angle;
        const Tensor<1, 3> outward({std::cos(phi), std::sin(phi), 0.});
        result.push_back(outward / kappa);
        result.push_back(first * outward);
        result.push_back(second * Tensor<1, 3>({0., 0., 1.}));
      }
    return result;
  };

  // The reference is straight.
  std::vector<Tensor<1, 3>> straight;
  for (unsigned int node = 0; node <= degree; ++node)
    {
      straight.push_back(
        Tensor<1, 3>({0., length * (double(node) / degree), 0.}));
      straight.push_back(Tensor<1, 3>({1., 0., 0.}));
      straight.push_back(Tensor<1, 3>({0., 0., 1.}));
    }
  std::vector<double> reference(element->n_strains());
  element->strains(straight.data(), length, reference.data());

  const unsigned int  n = 3 * element->n_blocks();
  std::vector<double> residual(n), tangent(n * n);
  const auto          unit1 = blocks(1., 0.), unit2 = blocks(0., 1.);
  // Derivatives of the blocks by the two stretches, as lists of numbers.
  const auto number = [](const std::vector<Tensor<1, 3>> &list,
                         const unsigned int               which,
                         const unsigned int               i) {
    return i / 3 % 3 == which ? list[i / 3][i % 3] : 0.;
  };
  double first = 1., second = 1.;
  for (unsigned int iteration = 0; iteration < 20; ++iteration)
    {
      element->assemble(section,
                        blocks(first, second).data(),
                        length,
                        reference.data(),
                        /*predicted_stresses=*/nullptr,
                        residual.data(),
                        tangent.data());
      double r1 = 0., r2 = 0., k11 = 0., k12 = 0., k22 = 0.;
      for (unsigned int i = 0; i < n; ++i)
        {
          r1 += residual[i] * number(unit1, 1, i);
          r2 += residual[i] * number(unit2, 2, i);
          for (unsigned int j = 0; j < n; ++j)
            {
              const double k = tangent[i * n + j];
              k11 += k * number(unit1, 1, i) * number(unit1, 1, j);
              k12 += k * number(unit1, 1, i) * number(unit2, 2, j);
              k22 += k * number(unit2, 2, i) * number(unit2, 2, j);
            }
        }
      const double determinant = k11 * k22 - k12 * k12;
      first -= (k22 * r1 - k12 * r2) / determinant;
      second -= (k11 * r2 - k12 * r1) / determinant;
    }
  return first;
}



void
print(const std::string   &name,
      const Beam::Section &section,
      const double         exact,
      const unsigned int   degree)
{
  double before = 0.;
  for (const double angle : {.4, .2, .1})
    {
      const double error = stretch(section, degree, angle) - std::sqrt(exact);
      // No more digits than round-off leaves.
      std::ostringstream digits;
      digits << std::scientific << std::setprecision(2) << error;
      deallog << name << ", degree " << degree << ", angle " << angle
              << ": error " << digits.str();
      if (before != 0.)
        deallog << ", order " << rounded(std::log2(before / error), 2);
      deallog << std::endl;
      before = error;
    }
}



int
main()
{
  initlog();
  const double half_square = std::pow(kappa * radius / 2., 2);
  for (const unsigned int degree : {1, 2, 3})
    for (const double nu : {0., .3})
      {
        const std::string with_nu = ", nu " + std::to_string(nu).substr(0, 3);
        const auto   soft = Beam::circular_section(radius, 1., 1. / 72., nu);
        const double isotropic = .5 / (1. + nu);
        print("soft in shear" + with_nu,
              soft,
              1. - (1. - nu) / isotropic * half_square,
              degree);
        Beam::Section given = soft;
        given.thickness *= .2;
        given.gradient *= .2;
        print("a fifth of its stiffness" + with_nu,
              given,
              1. - (1. - nu) / (.2 * isotropic) * half_square,
              degree);
      }
}
