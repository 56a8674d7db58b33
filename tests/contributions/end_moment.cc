// An end moment that grows by 22.5 degrees per step rolls a cantilever of unit
// length up to a full circle, in at most 7 iterations per step, for both
// elements, through contributions, block system and solver. Tip error in units
// of 1e-6 L.
#include "scene.h"

void
test(const std::string &element, const unsigned int degree)
{
  Scene scene;
  scene.fibers.element_name  = element;
  scene.fibers.degree        = degree;
  scene.fibers.axial_modulus = 4e12 / M_PI;
  scene.fibers.poisson_ratio = 0.3;
  scene.clamp("first end");
  scene.add_load().moment[2] = "2*pi*t";
  scene.build({straight_path(Tensor<1, 3>(),
                             Tensor<1, 3>({1., 0., 0.}),
                             /*n_knots=*/49,
                             /*radius=*/1e-3)});
  unsigned int most      = 0;
  bool         converged = true;
  for (unsigned int step = 1; step <= 16; ++step)
    {
      const auto result = scene.solve(step / 16.);
      most              = std::max(most, result.iterations);
      converged         = converged && result.converged;
    }
  const auto   values = scene.report();
  const double error  = std::hypot(values.at("load_1_displacement_x[mm]") + 1.,
                                  values.at("load_1_displacement_y[mm]"));
  deallog << element << ' ' << degree << ": converged " << converged
          << ", iterations at most " << most << ", error "
          << std::round(1e6 * error)
          << verdict(converged && most <= 7 &&
                     error < (degree == 1 ? 1e-2 : 1e-4))
          << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  test("hermite", 3);
  test("director", 1);
  test("director", 2);
  test("director", 3);
}
