// Cantilevers through contributions, block system and solver: under a tip
// force, and under end moments in the plane and in space.
#include <heddle/base/choice.h>

#include "scene.h"

#include <iomanip>

/**
 * A clamped cantilever under the tip force P L^2 / EI = 10 in one load step,
 * through contributions, block system and solver: at most 9 iterations from a
 * slenderness of 10 to 10000, at the exact tip displacement, and the reaction
 * balances the load. Displacement errors in units of 1e-6 L; the extensible
 * fiber of slenderness 10 is another problem.
 */
void
tip_force()
{
  for (const std::string element : {"hermite", "director"})
    for (const double slenderness : {10., 100., 1000., 10000.})
      {
        Scene scene;
        scene.fibers.element_kind =
          Heddle::choice<Heddle::Beam::ElementKind>(element);
        scene.fibers.degree                 = 3;
        scene.fibers.material.axial_modulus = 1.;
        scene.fibers.material.poisson_ratio = 0.;
        const double radius                 = .5 / slenderness;
        const double bending                = M_PI / 4. * std::pow(radius, 4);
        scene.clamp("first end");
        auto              &load = scene.add_load();
        std::ostringstream force;
        force << std::setprecision(17) << 10. * bending;
        load.force[1] = "t*" + force.str();
        scene.build({straight_path(Tensor<1, 3>(),
                                   Tensor<1, 3>({1., 0., 0.}),
                                   /*n_knots=*/element == "hermite" ? 17 : 49,
                                   radius)});
        const auto         result = scene.solve(1.);
        const Tensor<1, 3> tip    = scene.block(0, scene.last_node());
        const double error = std::hypot(tip[1] - .81061, 1. - tip[0] - .55500);
        const double balance =
          scene.report()["support_1_force_y[N]"] / (10. * bending) + 1.;
        deallog << element << ", slenderness " << slenderness << ": iterations "
                << result.iterations << ", residual "
                << (result.residual_ratio < 1e-5 ? "balanced" : "large")
                << ", error " << std::round(1e6 * error)
                << verdict(result.converged && result.iterations <= 9 &&
                           (slenderness < 1e3 || error < 1e-5) &&
                           std::abs(balance) < 1e-4)
                << std::endl;
      }
}



/** A cantilever of unit length and E I = 1 under a moment at its end. */
class Turned : public Scene
{
public:
  Turned(const std::string                &element,
         const unsigned int                degree,
         const unsigned int                n_knots,
         const std::array<std::string, 3> &moment)
  {
    fibers.element_kind = Heddle::choice<Heddle::Beam::ElementKind>(element);
    fibers.degree       = degree;
    fibers.material.axial_modulus = 4e12 / M_PI;
    fibers.material.poisson_ratio = 0.3;
    clamp("first end");
    add_load().moment = moment;
    build({straight_path(Tensor<1, 3>(),
                         Tensor<1, 3>({1., 0., 0.}),
                         n_knots,
                         /*radius=*/1e-3)});
  }

  /** Turn in so many equal steps; most iterations are those of one of them. */
  void
  turn(const unsigned int n_steps)
  {
    for (unsigned int step = 1; step <= n_steps; ++step)
      {
        const auto result = solve(double(step) / n_steps);
        most              = std::max(most, result.iterations);
        converged         = converged && result.converged;
      }
  }

  unsigned int most      = 0;
  bool         converged = true;
};



void
roll_up_one(const std::string &element, const unsigned int degree)
{
  Turned scene(element, degree, /*n_knots=*/49, {{"0", "0", "2*pi*t"}});
  scene.turn(16);
  const auto   values = scene.report();
  const double error  = std::hypot(values.at("load_1_displacement_x[mm]") + 1.,
                                  values.at("load_1_displacement_y[mm]"));
  deallog << element << ' ' << degree << ": converged " << scene.converged
          << ", iterations at most " << scene.most << ", error "
          << std::round(1e6 * error)
          << verdict(scene.converged && scene.most <= 7 &&
                     error < (degree == 1 ? 1e-2 : 1e-4))
          << std::endl;
}



/**
 * An end moment that grows by 22.5 degrees per step rolls a cantilever of unit
 * length up to a full circle, in at most 7 iterations per step, for both
 * elements, through contributions, block system and solver. Tip error in units
 * of 1e-6 L.
 */
void
roll_up()
{
  roll_up_one("hermite", 3);
  roll_up_one("director", 1);
  roll_up_one("director", 2);
  roll_up_one("director", 3);
}



constexpr double angle = 2.5; // M L / EI
constexpr double along = 0.6, across = 0.8;



/** The end of a helix that begins along x and turns about (0.6, 0, 0.8). */
Tensor<1, 3>
end_of_helix()
{
  const Tensor<1, 3> axis({along, 0., across}), first({1., 0., 0.});
  const Tensor<1, 3> drift = (axis * first) * axis;
  return drift + std::sin(angle) / angle * (first - drift) +
         (1. - std::cos(angle)) / angle * cross_product_3d(axis, first);
}



/**
 * The end of an arc in the plane of x and (0, cos(t), sin(t)): its curvature k
 * is M_z cos(t), and tan(k) = M_z sin(t) / M_x.
 */
Tensor<1, 3>
end_of_arc()
{
  const double bending = across * angle, axial = along * angle;
  double       low = 0., high = M_PI / 2.;
  while (high - low > 1e-14)
    {
      const double t = 0.5 * (low + high), k = bending * std::cos(t);
      (bending * std::sin(t) * std::cos(k) < axial * std::sin(k) ? low : high) =
        t;
    }
  const double k    = bending * std::cos(low);
  const double rise = (1. - std::cos(k)) / k;
  return Tensor<1, 3>(
    {std::sin(k) / k, rise * std::cos(low), rise * std::sin(low)});
}



void
turn_in_space(const std::string &element,
              const unsigned int degree,
              const unsigned int coarsest,
              const double       allowed)
{
  const Tensor<1, 3> tip = element == "hermite" ? end_of_arc() : end_of_helix();
  // A section yields to its moments by the square of its radius and stretches.
  const double       floor       = element == "hermite" ? 5e-7 : 1e-5;
  const unsigned int per_element = element == "hermite" ? 1 : degree;
  double             before      = 0.;
  for (unsigned int n = coarsest; n <= 4 * coarsest; n *= 2)
    {
      Turned scene(element,
                   degree,
                   /*n_knots=*/per_element * n + 1,
                   {{std::to_string(along * angle) + "*t",
                     "0",
                     std::to_string(across * angle) + "*t"}});
      scene.turn(5);
      const auto   values = scene.report();
      Tensor<1, 3> end({1., 0., 0.});
      for (unsigned int d = 0; d < 3; ++d)
        end[d] +=
          values.at(std::string("load_1_displacement_") + "xyz"[d] + "[mm]");
      const double error = (end - tip).norm();
      deallog << element << ' ' << degree << ", elements " << n
              << ": converged " << scene.converged << ", iterations at most "
              << scene.most << ", error " << std::round(1e7 * error) / 10.;
      if (before > 0. && error > floor)
        deallog << ", order "
                << std::round(10. * std::log2(before / error)) / 10.;
      deallog << verdict(scene.converged && scene.most <= 9 &&
                         (n < 4 * coarsest || error < allowed))
              << std::endl;
      before = error;
    }
}



/**
 * An end moment of fixed direction, at 53 degrees to a straight cantilever of
 * unit length: where fibers have sections the moment is the same in all of
 * them, the part of it across the tangent bends, and the tangent turns about it
 * at the rate M/EI, whatever torsion does: a helix with M as its axis. A fiber
 * without sections knows no torsion and remains in a plane, which contains its
 * first tangent; its last one is where the part of the moment across it is at
 * right angles to that plane. Such a moment has no potential, and the tangent
 * has unsymmetric terms. Errors of the tip in units of 1e-6 L.
 */
void
moment_in_space()
{
  turn_in_space("hermite", 3, 2, 5e-5);
  turn_in_space("director", 1, 12, 5e-3);
  turn_in_space("director", 2, 6, 5e-5);
  turn_in_space("director", 3, 4, 5e-5);
}



int
main(int argc, char **argv)
{
  const MPITest mpi(argc, argv);
  run_part("Tip force", tip_force);
  run_part("Rolled up to a circle", roll_up);
  run_part("Moment in space", moment_in_space);
}
