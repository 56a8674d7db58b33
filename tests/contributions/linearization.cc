// One Newton step leaves nothing of the forces to first order.
#include <heddle/base/choice.h>

#include "../verification/composite.h"
#include "newton_step.h"

std::unique_ptr<Scene>
make_scene(const std::string &element)
{
  auto scene = std::make_unique<Scene>();
  scene->fibers.element_kind =
    Heddle::choice<Heddle::Beam::ElementKind>(element);
  scene->fibers.degree                 = 2;
  scene->fibers.material.axial_modulus = 1e3;
  scene->clamp("first end");
  auto &turned           = scene->add_support();
  turned.nodes.nodes     = Heddle::Contributions::ChosenNodes::last_end;
  turned.displacement[1] = "0.3*t";
  turned.section         = Heddle::Contributions::SupportedSection::turned;
  turned.angle           = "t";
  turned.axis            = Tensor<1, 3>({1., 2., 3.});
  auto &load             = scene->add_load();
  load.nodes.nodes       = Heddle::Contributions::ChosenNodes::all;
  load.force             = {{"1", "2", "x"}};
  load.moment            = {{"2", "1", "-1"}};
  scene->build({straight_path(Tensor<1, 3>(),
                              Tensor<1, 3>({0.6, 0.8, 0.}),
                              9,
                              /*radius=*/0.1)});
  return scene;
}



void
test_supported(const std::string &element)
{
  const auto scene          = make_scene(element);
  scene->state->load_factor = 1.;
  NewtonStep         step   = take_newton_step(*scene);
  const unsigned int n      = step.before.size();
  const double       rest   = largest(step.rest, 0, n);
  const double       scale  = largest(step.before, 0, n);
  const unsigned int n_held = step.constraints.size();
  step.constraints.clear();
  scene->contributions[1]->constrain(*scene->state, step.constraints);
  double pending = 0.;
  for (const auto &constraint : step.constraints)
    for (const double motion : constraint.pending)
      pending = std::max(pending, std::abs(motion));
  deallog << element << ": " << n_held << " blocks held; first-order balance "
          << (rest < 1e-6 * scale ? "holds" : "FAIL ") << ", held motion "
          << (pending < 1e-12 ? "exact" : "FAIL") << std::endl;
}



/**
 * One Newton step from a disturbed configuration, with prescribed motions along
 * the axes and in a frame that lies askew, dead forces and moments: the
 * residual vanishes to first order in all that is free, judged by differences,
 * and what is held moves as told. Errors as a part of the residual.
 */
void
supported_fibers()
{
  test_supported("hermite");
  test_supported("director");
}



void
test_composite(const std::string &element,
               const std::string &law,
               const unsigned int n_points)
{
  Composite scene(
    mesh(3, 2, Tensor<1, 3>({3., 1., 1.})) + " set Law = " + law +
    "\n set Coupling points per element = " + std::to_string(n_points) +
    "\n set Coupling stiffness factor = 20\n");
  scene.fibers.element_kind =
    Heddle::choice<Heddle::Beam::ElementKind>(element);
  scene.fibers.material.axial_modulus = 100.;
  scene.hold({"x-"}).displacement     = {{"0", "0", "0"}};
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



/**
 * One Newton step of a fiber in a matrix from a disturbed configuration, by the
 * whole tangent: the residual vanishes to first order, judged by differences,
 * in the fiber as well as in the matrix. For the laws of the matrix, elements
 * of the fiber, links in nodes and at points between them.
 */
void
composites()
{
  for (const std::string element : {"hermite", "director"})
    for (const std::string law :
         {"linear", "st venant-kirchhoff", "neo-hookean"})
      for (const unsigned int n_points : {0, 2})
        test_composite(element, law, n_points);
}



int
main(int argc, char **argv)
{
  const MPITest mpi(argc, argv);
  run_part("Fibers with supports and loads", supported_fibers);
  run_part("A fiber in a matrix", composites);
}
