// The section of a fiber: its law, how it flattens in bending, and what a user
// can get wrong about it and its element.
#include <heddle/base/exceptions.h>

#include "random_element.h"

#include <iomanip>
#include <sstream>

using namespace Heddle;

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
  return Heddle::Beam::make_element(Beam::ElementKind::director, 1)
    ->assemble(section,
               blocks.data(),
               /*length=*/1.,
               reference.data(),
               /*predicted_stresses=*/nullptr,
               /*residual=*/nullptr,
               /*tangent=*/nullptr);
}



/**
 * For an isotropic fiber the law of axial strain and section stretch is the
 * three-dimensional one. A section that is free to stretch contracts by
 * Poisson's ratio, with exactly EA, also where E and G are independent.
 */
void
law()
{
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



constexpr double bent_radius = 1., kappa = .4;



/** Equilibrium of the stretches of both section vectors; return the first. */
double
stretch(const Beam::Section &section, const unsigned int degree, double angle)
{
  const auto element  = Beam::make_element(Beam::ElementKind::director, degree);
  const double length = angle / kappa;
  const auto   blocks = [&](const double first, const double second) {
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



/**
 * The section of a fiber that is bent to the curvature kappa flattens until
 * g_1^2 = 1 - (1 - nu) E / S (kappa R / 2)^2, where S resists it: found by
 * Newton's method on one element of an arc, at several angles of it. A fiber
 * that is soft in shear flattens no more than an isotropic one.
 */
void
bending()
{
  const double half_square = std::pow(kappa * bent_radius / 2., 2);
  for (const unsigned int degree : {1, 2, 3})
    for (const double nu : {0., .3})
      {
        const std::string with_nu = ", nu " + std::to_string(nu).substr(0, 3);
        const auto soft = Beam::circular_section(bent_radius, 1., 1. / 72., nu);
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



template <typename Function>
void
report(const Function &function)
{
  try
    {
      function();
      deallog << "accepted" << std::endl;
    }
  catch (const Heddle::InputError &error)
    {
      deallog << error.what() << std::endl;
    }
}



/** What a user can get wrong about a fiber is said in one sentence. */
void
input_errors()
{
  using namespace Beam;
  report([]() { make_element(ElementKind::director, 4); });
  report([]() { make_element(ElementKind::director, 2); });
  report([]() { make_element(ElementKind::hermite, 0); });
  report([]() { circular_section(-1., 1., 1., .3); });
  report([]() { circular_section(1., 0., 1., .3); });
  report([]() { circular_section(1., 1., -2., .3); });
  report([]() { circular_section(1., 1., 1., .5); });
  report([]() { circular_section(1., 1., 1., -.1); });
  report([]() { circular_section(1., 1., .02, .49); });
}



int
main()
{
  initlog();
  run_part("Law", law);
  run_part("In bending", bending);
  run_part("Input errors", input_errors);
}
