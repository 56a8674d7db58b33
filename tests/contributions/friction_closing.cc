// Friction where it begins, and where there is no side to rub: a fiber comes
// down on another one and is dragged across it in the same step, which must
// give mu N in any number of steps; an end that is pushed on a fiber at an
// angle slides with less than mu, straight on without friction; and ends that
// meet have forces.
#include <heddle/base/choice.h>
#include <heddle/contributions/fiber_friction.h>

#include "scene.h"

const double radius = 1., friction = 0.3, depth = 0.01;



/** Fiber 1 moves as prescribed, fiber 0 not at all. */
void
prescribe(Scene             &scene,
          const std::string &element,
          const std::string &along_x,
          const std::string &along_z)
{
  scene.fibers.element_kind =
    Heddle::choice<Heddle::Beam::ElementKind>(element);
  scene.fibers.material.axial_modulus = 1e4;
  for (const std::string fiber : {"0", "1"})
    {
      auto &support        = scene.clamp("all", fiber);
      support.displacement = {
        {fiber == "0" ? "0" : along_x, "0", fiber == "0" ? "0" : along_z}};
    }
}



void
touch(Scene &scene, Contact::ContactParameters &contact)
{
  contact.friction                = friction;
  contact.reversible_displacement = 0.005;
  const auto touching =
    std::make_shared<Contributions::FiberContact>(*scene.space, contact);
  scene.contributions.push_back(touching);
  scene.contributions.push_back(std::make_shared<Contributions::FiberFriction>(
    *scene.space, contact, *touching));
}



/** Drag over mu N, after so many steps to load factor 1. */
double
drag(Scene &scene, const unsigned int n_steps)
{
  bool converged = scene.step(0.).converged;
  for (unsigned int k = 1; k <= n_steps; ++k)
    converged = scene.step(double(k) / n_steps).converged && converged;
  auto         values = scene.report();
  const double ratio  = values["support_2_force_x[N]"] /
                       (friction * std::abs(values["support_2_force_z[N]"]));
  return converged && ratio == ratio ? std::round(1e3 * ratio) / 1e3 + 0. : -1.;
}



void
close_and_drag(const std::string &element)
{
  deallog << element << ", closing and dragged: drag over mu N in";
  for (const unsigned int n_steps : {1, 2, 4, 8})
    {
      Scene                      scene;
      Contact::ContactParameters contact;
      prescribe(scene, element, "0.2*t", "-0.02*t");
      const Tensor<1, 3> x({1., 0., 0.}), y({0., 1., 0.}), z({0., 0., 1.});
      const Tensor<1, 3> up = (2. * radius + depth) * z;
      scene.build({straight_path(-4. * x, 4. * x, 9, radius),
                   straight_path(up - 4. * y, up + 4. * y, 9, radius)});
      touch(scene, contact);
      deallog << ' ' << n_steps << " steps " << drag(scene, n_steps);
    }
  deallog << std::endl;
}



void
push_an_end(const std::string &element)
{
  deallog << element << ", an end: drag over mu N, and sin^2 / 0.3, at";
  for (const double angle : {0., 0.02, 0.3, 1.})
    {
      Scene                      scene;
      Contact::ContactParameters contact;
      prescribe(scene, element, "0.2*t", "0");
      const Tensor<1, 3> x({1., 0., 0.});
      const Tensor<1, 3> end({0., 0., 2. * radius - depth});
      const Tensor<1, 3> away({0., std::sin(angle), std::cos(angle)});
      scene.build({straight_path(-4. * x, 4. * x, 9, radius),
                   straight_path(end, end + 8. * away, 9, radius)});
      touch(scene, contact);
      deallog << ' ' << angle << " rad " << drag(scene, 4) << " ("
              << std::round(1e3 *
                            std::min(1., std::pow(std::sin(angle), 2) / 0.3)) /
                   1e3
              << ')';
    }
  deallog << std::endl;
}



void
meet_end_to_end(const std::string &element)
{
  Scene                      scene;
  Contact::ContactParameters contact;
  prescribe(scene, element, "-0.01*t", "0");
  const Tensor<1, 3> x({1., 0., 0.});
  scene.build({straight_path(-8. * x, Tensor<1, 3>(), 9, radius),
               straight_path(2. * radius * x, 10. * x, 9, radius)});
  touch(scene, contact);
  const bool found = scene.step(0.).converged && scene.step(0.5).converged &&
                     scene.step(1.).converged;
  auto values = scene.report();
  deallog << element << ", end to end: " << (found ? "" : "not converged, ")
          << "pushed apart " << (values["support_2_force_x[N]"] < 0.)
          << ", slipping or sticking "
          << (values["friction_stored[N*mm]"] +
                values["friction_dissipated[N*mm]"] !=
              0.)
          << std::endl;
}



int
main(int argc, char **argv)
{
  const MPITest mpi(argc, argv);
  for (const std::string element : {"hermite", "director"})
    {
      close_and_drag(element);
      push_an_end(element);
      meet_end_to_end(element);
    }
}
