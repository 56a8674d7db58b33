// Friction elements, as long as they stay where they are: the tangent is the
// derivative of the residual, symmetric, with order two in the difference, in
// stick and in slip. Forces are in balance. A rotation of everything between
// two steps causes no friction, and turns the friction that was there. What is
// remembered does not jump.
#include <heddle/contributions/fiber_friction.h>

#include "../contact/contact_scene.h"
#include "../tests.h"

constexpr unsigned int n_intervals = 8;

using namespace Heddle;

using Motion = std::vector<Tensor<1, 3>>;

double
dot(const Motion &a, const Motion &b)
{
  double sum = 0.;
  for (unsigned int i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}



/** Two wavy fibers that overlap, cross at @p angle, and rub. */
class RubbingScene
{
public:
  RubbingScene(const std::string &element,
               const double       angle,
               const double       reversible)
    : random(3)
    , scene(paths(angle, random), {n_intervals, n_intervals}, options(element))
  {
    scene.parameters.friction                = 0.3;
    scene.parameters.reversible_displacement = reversible;
    friction = std::make_unique<Contributions::FiberFriction>(
      scene.space, scene.parameters, *scene.contact);
    scene.state.accept();
    move(2e-2);
    place();
  }

  /** Take contacts and particles from the configuration as it is. */
  void
  place()
  {
    scene.contact->begin_step(scene.state);
    scene.contact->update(scene.state);
    friction->update(scene.state);
  }

  /** Move all blocks at random, and by up to @p size. */
  void
  move(const double size)
  {
    scene.state.move(size, random_motion());
  }

  Motion
  random_motion()
  {
    Motion motion(scene.state.n_owned_blocks());
    for (Tensor<1, 3> &block : motion)
      block = random.between(-1., 1.) * random.direction();
    return motion;
  }

  Motion
  residual()
  {
    System::BlockSystem system(scene.state);
    system.begin(System::BlockSystem::Want::residual);
    friction->assemble(scene.state, system);
    return system.residual();
  }

  /** The tangent times a motion. */
  Motion
  tangent_times(const Motion &motion)
  {
    System::BlockSystem  system(scene.state);
    System::BlockPattern pattern(scene.state.n_owned_blocks());
    friction->add_pattern(scene.state, pattern);
    system.set_pattern(pattern);
    system.set_constraints({});
    system.begin(System::BlockSystem::Want::residual_and_tangent);
    friction->assemble(scene.state, system);
    system.end();
    return scene.times(system, motion);
  }

  /** Turn everything about an axis that is none of the fibers'. */
  void
  turn(const double angle)
  {
    const Tensor<2, 3> q      = rotation(angle);
    Motion             values = scene.state.current();
    for (Tensor<1, 3> &block : values)
      block = q * block;
    scene.state.set(values);
  }

  static Tensor<2, 3>
  rotation(const double angle)
  {
    Tensor<1, 3> axis({0.6, 0.48, 0.64});
    Tensor<2, 3> q;
    for (unsigned int d = 0; d < 3; ++d)
      {
        Tensor<1, 3> e;
        e[d] = 1.;
        const Tensor<1, 3> turned =
          std::cos(angle) * e + std::sin(angle) * cross_product_3d(axis, e) +
          (1. - std::cos(angle)) * (axis * e) * axis;
        for (unsigned int c = 0; c < 3; ++c)
          q[c][d] = turned[c];
      }
    return q;
  }

  RandomNumbers                                 random;
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
  paths(const double angle, RandomNumbers &random)
  {
    const auto fiber = [&](const double alpha, const double height) {
      const Tensor<1, 3> direction({std::cos(alpha), std::sin(alpha), 0.});
      return wavy_line(Tensor<1, 3>({0., 0., height}) - 10. * direction,
                       direction,
                       /*length=*/20.,
                       /*height=*/0.02,
                       random);
    };
    const Path lower = fiber(0., 0.);
    return {lower, fiber(angle, 1.95)};
  }
};



void
derivatives(const std::string &element,
            const double       angle,
            const double       reversible)
{
  RubbingScene rubbing(element, angle, reversible);
  rubbing.move(1e-3);
  const Motion start = rubbing.scene.state.current();
  const Motion along = rubbing.random_motion(), other = rubbing.random_motion();
  const Motion product = rubbing.tangent_times(along);
  const double symmetry =
    std::abs(dot(other, product) - dot(along, rubbing.tangent_times(other))) /
    std::abs(dot(other, product));
  double errors[2];
  for (unsigned int k = 0; k < 2; ++k)
    {
      const double h = k == 0 ? 2e-4 : 1e-4;
      rubbing.scene.state.move(h, along);
      Motion difference = rubbing.residual();
      rubbing.scene.state.set(start);
      rubbing.scene.state.move(-h, along);
      const Motion below = rubbing.residual();
      rubbing.scene.state.set(start);
      for (unsigned int b = 0; b < difference.size(); ++b)
        difference[b] = (difference[b] - below[b]) / (2. * h) - product[b];
      errors[k] =
        std::sqrt(dot(difference, difference) / dot(product, product));
    }
  const bool exact = errors[1] < 1e-9;
  deallog << element << ", " << angle * 180. / numbers::PI
          << " degrees, reversible displacement " << reversible
          << ": tangent is symmetric " << (symmetry < 1e-12)
          << ", its error is "
          << (exact ? std::string("round-off")
                    : "of order " + std::to_string(std::lround(
                                      std::log2(errors[0] / errors[1]))))
          << (exact || errors[1] < 1e-3 ? "" : " FAIL") << std::endl;
}



void
rigid_motion(const std::string &element, const double angle)
{
  RubbingScene rubbing(element, angle, 0.05);
  const Motion before = rubbing.residual();
  const Motion start  = rubbing.scene.state.current();
  rubbing.friction->accept_step(rubbing.scene.state);
  rubbing.scene.state.accept();
  rubbing.turn(0.7);
  rubbing.place();
  Motion             after = rubbing.residual();
  const Tensor<2, 3> back  = transpose(RubbingScene::rotation(0.7));
  Tensor<1, 3>       force, moment;
  double             sum = 0.;
  for (unsigned int b = 0; b < after.size(); ++b)
    {
      sum += after[b].norm();
      after[b] = back * after[b] - before[b];
      if (b % rubbing.scene.space.n_blocks_per_node() == 0)
        force += before[b];
      moment += cross_product_3d(start[b], before[b]);
    }
  const double change = std::sqrt(dot(after, after) / dot(before, before));
  deallog << element << ", " << angle * 180. / numbers::PI
          << " degrees: forces turn along " << (change < 1e-6)
          << ", and are in balance " << (force.norm() < 1e-12 * sum)
          << ", moments but for the penetration "
          << (moment.norm() < 0.02 * sum) << std::endl;
}



/**
 * What the last step left is a continuous function of the particles, and
 * finding them ten times changes nothing.
 */
void
memory(const std::string &element, const double angle)
{
  RubbingScene rubbing(element, angle, 0.05);
  rubbing.friction->accept_step(rubbing.scene.state);
  rubbing.scene.state.accept();
  rubbing.place();
  const Motion start  = rubbing.scene.state.current();
  const Motion before = rubbing.residual();
  const auto   change = [&]() {
    Motion difference = rubbing.residual();
    for (unsigned int b = 0; b < difference.size(); ++b)
      difference[b] -= before[b];
    return std::sqrt(dot(difference, difference) / dot(before, before));
  };
  for (unsigned int k = 0; k < 10; ++k)
    rubbing.place();
  const double again = change();

  double largest = 0.;
  for (unsigned int k = 0; k < 100; ++k)
    {
      rubbing.move(1e-9);
      rubbing.place();
      largest = std::max(largest, change());
      rubbing.scene.state.set(start);
    }
  deallog << element << ", " << angle * 180. / numbers::PI
          << " degrees: placed ten times changes nothing " << (again < 1e-6)
          << ", moved by 1e-9 little " << (largest < 1e-5) << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  for (const std::string element : {"hermite", "director"})
    for (const double angle : {0.02, 0.6, 1.5})
      {
        for (const double reversible : {0.5, 1e-3})
          derivatives(element, angle, reversible);
        rigid_motion(element, angle);
        memory(element, angle);
      }
}
