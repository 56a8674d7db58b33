// One Newton step of a fiber in a matrix from a disturbed configuration, by the
// whole tangent: the residual vanishes to first order, judged by differences,
// in the fiber as well as in the matrix. For the laws of the matrix, elements
// of the fiber, links in nodes and at points between them.
#include "../verification/composite.h"
#include "newton_step.h"



void
test(const std::string &element,
     const std::string &law,
     const unsigned int n_points)
{
  Composite scene(
    mesh(3, 2, Tensor<1, 3>({3., 1., 1.})) + " set Law = " + law +
    "\n set Coupling points per element = " + std::to_string(n_points) +
    "\n set Coupling stiffness factor = 20\n");
  scene.fibers.element_name       = element;
  scene.fibers.axial_modulus      = 100.;
  scene.hold({"x-"}).displacement = {{"0", "0", "0"}};
  scene.embed({straight_path(Tensor<1, 3>({0.1, 0.2, 0.3}),
                             Tensor<1, 3>({2.8, 0.9, 0.6}),
                             9,
                             /*radius=*/0.1)});
  const NewtonStep   step      = take_newton_step(scene);
  const unsigned int n         = step.before.size();
  const unsigned int n_fiber   = scene.state->n_owned_fiber_blocks();
  const double       of_fiber  = largest(step.rest, 0, n_fiber);
  const double       of_matrix = largest(step.rest, n_fiber, n);
  const double       scale     = largest(step.before, 0, n);
  print(element + ", " + law + ", fiber", n_points, of_fiber / scale);
  print(element + ", " + law + ", matrix", n_points, of_matrix / scale);
  deallog << element << ", " << law << ", " << n_points
          << " points: first-order balance of the fiber "
          << (of_fiber < 1e-6 * scale ? "holds" : "FAIL") << ", of the matrix "
          << (of_matrix < 1e-6 * scale ? "holds" : "FAIL") << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  for (const std::string element : {"hermite", "director"})
    for (const std::string law :
         {"linear", "st venant-kirchhoff", "neo-hookean"})
      for (const unsigned int n_points : {0, 2})
        test(element, law, n_points);
}
