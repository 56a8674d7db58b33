// One Newton step from a disturbed configuration, with prescribed motions along
// the axes and in a frame that lies askew, dead forces and moments: the
// residual vanishes to first order in all that is free, judged by differences,
// and what is held moves as told. Errors as a part of the residual.
#include "newton_step.h"



std::unique_ptr<Scene>
make_scene(const std::string &element)
{
  auto scene                  = std::make_unique<Scene>();
  scene->fibers.element_name  = element;
  scene->fibers.degree        = 2;
  scene->fibers.axial_modulus = 1e3;
  scene->clamp("first end");
  auto &turned           = scene->add_support();
  turned.nodes.nodes     = "last end";
  turned.displacement[1] = "0.3*t";
  turned.section         = "turned";
  turned.angle           = "t";
  turned.axis            = Tensor<1, 3>({1., 2., 3.});
  auto &load             = scene->add_load();
  load.nodes.nodes       = "all";
  load.force             = {{"1", "2", "x"}};
  load.moment            = {{"2", "1", "-1"}};
  scene->build({straight_path(Tensor<1, 3>(),
                              Tensor<1, 3>({0.6, 0.8, 0.}),
                              9,
                              /*radius=*/0.1)});
  return scene;
}



void
test(const std::string &element)
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



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  test("hermite");
  test("director");
}
