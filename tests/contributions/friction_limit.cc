// Friction follows the normal force: what the unsymmetric terms of the tangent
// make of a motion that lays two straight fibers deeper in each other is the
// derivative of the forces of friction, found anew at each depth, while they
// stick (within the reversible displacement) and while they slip. It is but for
// what the tangent of contact leaves out as well: faces and lengths of contact
// change with the depth. Errors by that, printed to the screen, fall with the
// depth; compared are bounds.
#include <heddle/contributions/fiber_friction.h>

#include "../contact/contact_scene.h"
#include "../tests.h"

#include <iostream>

constexpr unsigned int n_intervals = 16;

using namespace Heddle;

using Motion = std::vector<Tensor<1, 3>>;

double
norm(const Motion &motion)
{
  double sum = 0.;
  for (const Tensor<1, 3> &block : motion)
    sum += block.norm_square();
  return std::sqrt(sum);
}



/** A fiber, and another one on top of it at @p angle. */
class Pressed
{
public:
  Pressed(const std::string &element,
          const double       angle,
          const double       depth,
          const double       reversible)
    : scene(paths(angle, depth), {n_intervals, n_intervals}, options(element))
  {
    scene.parameters.friction                = 0.3;
    scene.parameters.reversible_displacement = reversible;
    friction = std::make_unique<Contributions::FiberFriction>(
      scene.space, scene.parameters, *scene.contact);
    scene.state.accept();
    scene.contact->begin_step(scene.state);
    place();
    friction->accept_step(scene.state);
    scene.state.accept();
  }

  void
  place()
  {
    scene.contact->update(scene.state);
    friction->update(scene.state);
  }

  /** All of the upper fiber by @p way. */
  Motion
  lift(const Tensor<1, 3> &way) const
  {
    Motion             motion(scene.state.n_owned_blocks());
    const unsigned int step = scene.space.n_blocks_per_node();
    for (unsigned int b = scene.state.local_block(1); b < motion.size();
         b += step)
      motion[b] = way;
    return motion;
  }

  Motion
  forces()
  {
    place();
    System::BlockSystem system(scene.state);
    system.begin(System::BlockSystem::Want::residual);
    friction->assemble(scene.state, system);
    return system.residual();
  }

  /** The whole tangent of friction times a motion. */
  Motion
  tangent_times(const Motion &motion)
  {
    place();
    System::BlockSystem  system(scene.state);
    System::BlockPattern pattern(scene.state.n_owned_blocks());
    friction->add_pattern(scene.state, pattern);
    system.set_pattern(pattern);
    system.set_constraints({});
    system.begin(System::BlockSystem::Want::residual_and_tangent);
    friction->assemble(scene.state, system);
    system.end();
    Motion result = scene.times(system, motion);
    system.unsymmetric_terms().add_product(motion, result);
    return result;
  }

  ContactScene                                  scene;
  std::unique_ptr<Contributions::FiberFriction> friction;

private:
  static ContactScene::Options
  options(const std::string &element)
  {
    ContactScene::Options result;
    result.element = element;
    return result;
  }

  static std::vector<Path>
  paths(const double angle, const double depth)
  {
    const auto fiber = [](const double alpha, const double height) -> Path {
      const Tensor<1, 3> along({std::cos(alpha), std::sin(alpha), 0.});
      const Tensor<1, 3> up({0., 0., height});
      return [=](const double t) { return up + 20. * (t - 0.5) * along; };
    };
    return {fiber(0., 0.), fiber(angle, 2. - depth)};
  }
};



double
error_of_tangent(const std::string &element,
                 const double       angle,
                 const double       depth,
                 const double       reversible)
{
  Pressed      pressed(element, angle, depth, reversible);
  const Motion rubbed = pressed.lift(Tensor<1, 3>({0.004, 0.001, 0.}));
  pressed.scene.state.move(1., rubbed);
  const Motion start   = pressed.scene.state.current();
  const Motion deeper  = pressed.lift(Tensor<1, 3>({0., 0., -1.}));
  const Motion product = pressed.tangent_times(deeper);
  const double h       = 1e-3 * depth;
  pressed.scene.state.move(h, deeper);
  Motion difference = pressed.forces();
  pressed.scene.state.set(start);
  pressed.scene.state.move(-h, deeper);
  const Motion above = pressed.forces();
  for (unsigned int b = 0; b < difference.size(); ++b)
    difference[b] = (difference[b] - above[b]) / (2. * h) - product[b];
  return norm(difference) / norm(product);
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  for (const std::string element : {"hermite", "director"})
    for (const double reversible : {0.1, 1e-3})
      for (const double angle : {0., 0.6, 1.5})
        {
          deallog << element << ", reversible displacement " << reversible
                  << ", angle " << angle << ": errors below";
          for (const auto &[depth, bound] :
               {std::pair(0.2, 0.05), {0.05, 0.02}, {0.0125, 5e-3}})
            {
              const double error =
                error_of_tangent(element, angle, depth, reversible);
              std::cout << "depth " << depth << ": error " << error
                        << std::endl;
              deallog << ' ' << bound << ' ' << (error < bound);
            }
          deallog << std::endl;
        }
}
