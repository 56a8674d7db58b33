// Elastica: a cantilever of unit length under a dead transverse tip force, all
// rows of the table (Mattiasson, 1981) against the exact solution, which agrees
// with the table to its five digits. Errors in units of 1e-6 L. The slenderness
// is 1000: below about 1e-6 the fibers differ from the elastica by their
// extensibility.
#include "single_fiber.h"

struct Row
{
  double load;  // P L^2 / EI
  double w;     // transverse displacement
  double u;     // shortening
  double angle; // of the tip
};

const std::vector<Row> table = {{.2, .06636, .00265, .09964},
                                {.4, .13098, .01035, .19715},
                                {.6, .19235, .02249, .29074},
                                {.8, .24945, .03817, .37906},
                                {1., .30172, .05643, .46135},
                                {1.5, .41098, .10794, .63954},
                                {2., .49346, .16064, .78175},
                                {3., .60325, .25442, .98602},
                                {4., .66996, .32894, 1.12124},
                                {5., .71379, .38763, 1.21537},
                                {6., .74457, .43459, 1.28370},
                                {7., .76737, .47293, 1.33496},
                                {8., .78498, .50483, 1.37443},
                                {9., .79906, .53182, 1.40547},
                                {10., .81061, .55500, 1.43029}};



/** Angle, curvature, x and y along the elastica. */
using Elastica = std::array<double, 4>;



/** Integrate theta'' = -load cos(theta) by the Runge-Kutta method. */
Elastica
integrate(const double load, const double curvature)
{
  const auto rate = [load](const Elastica &y) {
    return Elastica{
      {y[1], -load * std::cos(y[0]), std::cos(y[0]), std::sin(y[0])}};
  };
  const auto add = [](const Elastica &y, const Elastica &k, const double h) {
    return Elastica{
      {y[0] + h * k[0], y[1] + h * k[1], y[2] + h * k[2], y[3] + h * k[3]}};
  };
  const unsigned int n_steps = 400;
  const double       h       = 1. / n_steps;
  Elastica           y{{0., curvature, 0., 0.}};
  for (unsigned int i = 0; i < n_steps; ++i)
    {
      const Elastica k1 = rate(y);
      const Elastica k2 = rate(add(y, k1, .5 * h));
      const Elastica k3 = rate(add(y, k2, .5 * h));
      const Elastica k4 = rate(add(y, k3, h));
      y                 = add(y, k1, h / 6.);
      y                 = add(y, k2, h / 3.);
      y                 = add(y, k3, h / 3.);
      y                 = add(y, k4, h / 6.);
    }
  return y;
}



/**
 * Find the tip angle by bisection: theta'^2 / 2 + load sin(theta) is constant
 * and the tip has no curvature.
 */
Row
exact(const double load)
{
  double low = 0., high = .5 * M_PI;
  for (unsigned int i = 0; i < 50; ++i)
    {
      const double angle = .5 * (low + high);
      const auto end = integrate(load, std::sqrt(2. * load * std::sin(angle)));
      (end[1] > 0. ? high : low) = angle;
    }
  const auto end = integrate(load, std::sqrt(2. * load * std::sin(low)));
  return {load, end[3], 1. - end[2], end[0]};
}



/** Errors of displacements and angle, row by row. */
struct Errors
{
  std::vector<double> position;
  std::vector<double> angle;
};



Errors
compute(const Kind             &kind,
        const unsigned int      n_elements,
        const std::vector<Row> &rows)
{
  const auto  section = Heddle::Beam::circular_section(.5e-3, 1., 1. / 2.6, .3);
  SingleFiber fiber(kind, section, straight_line, /*length=*/1., n_elements);
  fiber.release_stretch();
  Errors errors;
  for (const Row &row : rows)
    {
      fiber.solve(Tensor<1, 3>({0., row.load * section.bending, 0.}));
      const Tensor<1, 3> reference({1. - row.u, row.w, 0.});
      errors.position.push_back((fiber.tip() - reference).norm());
      errors.angle.push_back(std::abs(fiber.tip_angle() - row.angle));
    }
  return errors;
}



/** Three meshes of one element, and what is allowed on the finest. */
void
test(const Kind             &kind,
     const unsigned int      coarsest,
     const double            allowed,
     const std::vector<Row> &rows)
{
  double before = 0.;
  for (unsigned int n = coarsest; n <= 4 * coarsest; n *= 2)
    {
      const Errors errors = compute(kind, n, rows);
      const double last   = errors.position.back();
      deallog << kind.name << ' ' << kind.degree << ", elements " << n
              << ": tip error at load 10 " << micro(last);
      if (before > 0. && last > 5e-6)
        deallog << ", order " << order(before, last);
      deallog << std::endl;
      before = last;

      if (n == 4 * coarsest)
        for (unsigned int i = 0; i < rows.size(); ++i)
          deallog << "  load " << rows[i].load << ": position "
                  << micro(errors.position[i]) << ", angle "
                  << micro(errors.angle[i])
                  << verdict(errors.position[i] < allowed &&
                             errors.angle[i] < 2. * allowed)
                  << std::endl;
    }
}



int
main()
{
  initlog();
  std::vector<Row> rows;
  bool             agrees = true;
  for (const Row &row : table)
    {
      rows.push_back(exact(row.load));
      agrees = agrees && std::abs(rows.back().w - row.w) < 5.1e-6 &&
               std::abs(rows.back().u - row.u) < 5.1e-6 &&
               std::abs(rows.back().angle - row.angle) < 5.1e-6;
    }
  deallog << "exact solution agrees with the table " << agrees
          << verdict(agrees) << std::endl;

  test({"hermite", 3}, /*coarsest=*/8, /*allowed=*/5e-6, rows);
  test({"director", 1}, /*coarsest=*/16, /*allowed=*/5e-4, rows);
  test({"director", 2}, /*coarsest=*/8, /*allowed=*/1e-4, rows);
  test({"director", 3}, /*coarsest=*/4, /*allowed=*/5e-6, rows);
}
