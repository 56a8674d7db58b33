// A clamped cantilever under the tip force P L^2 / EI = 10 in one load step,
// through contributions, block system and solver: at most 9 iterations from a
// slenderness of 10 to 10000, at the exact tip displacement, and the reaction
// balances the load. Displacement errors in units of 1e-6 L; the extensible
// fiber of slenderness 10 is another problem.
#include "scene.h"

#include <iomanip>

int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  for (const std::string element : {"hermite", "director"})
    for (const double slenderness : {10., 100., 1000., 10000.})
      {
        Scene scene;
        scene.fibers.element_name  = element;
        scene.fibers.degree        = 3;
        scene.fibers.axial_modulus = 1.;
        scene.fibers.poisson_ratio = 0.;
        const double radius        = .5 / slenderness;
        const double bending       = M_PI / 4. * std::pow(radius, 4);
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
