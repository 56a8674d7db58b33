// Contact elements act and react in one line. The assembled residual is the
// derivative of the energy, up to an error of quadrature that refinement
// removes. The tangent is the derivative of the residual but for the terms of
// the relative size penetration over distance that are left out on purpose;
// where forces turn it is all of it, but for errors of quadrature and for
// particles that give way where fibers turn.
#include "../contact/contact_scene.h"
#include "../tests.h"

constexpr unsigned int n_intervals = 10;

using Motion = std::vector<Tensor<1, 3>>;

/** Two wavy fibers at an angle, @p penetration deep at their closest. */
std::vector<Path>
wavy_pair(const double angle, const double penetration, RandomNumbers random)
{
  const auto fiber = [&](const double alpha, const double height) {
    const Tensor<1, 3> direction({std::cos(alpha), std::sin(alpha), 0.});
    return wavy_line(Tensor<1, 3>({0., 0., height}) - 20. * direction,
                     direction,
                     /*length=*/40.,
                     /*height=*/0.3,
                     random);
  };
  const Path a = fiber(0., 0.), b = fiber(angle, 2.);
  double     closest = 1e300;
  for (double t = 0.1; t < 0.9; t += 1e-3)
    for (double u = std::max(0.1, t - 0.2); u < std::min(0.9, t + 0.2);
         u += 1e-3)
      closest = std::min(closest, (a(t) - b(u)).norm());
  const Tensor<1, 3> up({0., 0., 2. - penetration - closest});
  return {a, [=](const double t) { return b(t) + up; }};
}



Motion
random_motion(const unsigned int n, RandomNumbers &random)
{
  Motion motion(n);
  for (unsigned int b = 0; b < n; ++b)
    motion[b] = (b % 2 == 0 ? 1. : 0.2) * random.direction();
  return motion;
}



double
dot(const Motion &a, const Motion &b)
{
  double sum = 0.;
  for (unsigned int i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}



/** Largest couple of one element, and resultants of all, over the forces. */
double
imbalance(ContactScene &scene)
{
  const Motion &forces = scene.forces();
  Tensor<1, 3>  force, moment;
  double        sum = 0., largest = 0.;
  for (unsigned int b = 0; b < forces.size(); ++b)
    {
      if (b % 2 == 0)
        force += forces[b];
      moment += cross_product_3d(scene.state.current()[b], forces[b]);
      sum += forces[b].norm();
    }
  for (const auto &element : scene.contact->elements())
    {
      Tensor<1, 3> connection;
      for (unsigned int side = 0; side < 2; ++side)
        {
          const unsigned int f = side == 0 ? element.fiber_a : element.fiber_b;
          const auto         point =
            scene.space.locate(f, side == 0 ? element.s_a : element.s_b);
          for (unsigned int i = 0; i < 4; ++i)
            connection += (side == 0 ? 1. : -1.) * point.values[i] *
                          scene.state.fiber(f)[point.blocks[i]];
        }
      largest =
        std::max({largest,
                  cross_product_3d(connection, element.normal).norm(),
                  std::abs(connection * element.normal - 2. - element.gap)});
    }
  return std::max({largest, force.norm() / sum, moment.norm() / sum / 40.});
}



double
error_of_residual(ContactScene &scene, RandomNumbers &random)
{
  const Motion motion = random_motion(scene.state.n_owned_blocks(), random);
  const double work   = dot(scene.forces(), motion);
  const auto   start  = scene.state.current();
  const double h      = 1e-5;
  scene.state.move(h, motion);
  scene.contact->update(scene.state);
  const double high = scene.energy();
  scene.state.move(-2. * h, motion);
  scene.contact->update(scene.state);
  const double low = scene.energy();
  scene.state.set(start);

  double size = 0.;
  for (const auto &element : scene.contact->elements())
    size += element.force;
  return std::abs((high - low) / (2. * h) - work) / size;
}



double
error_of_tangent(ContactScene &scene, RandomNumbers &random)
{
  const Motion motion  = random_motion(scene.state.n_owned_blocks(), random);
  const Motion tangent = scene.tangent_times(motion);
  const auto   start   = scene.state.current();
  const double h       = 1e-6;
  scene.state.move(h, motion);
  const Motion high = scene.forces();
  scene.state.move(-2. * h, motion);
  const Motion low = scene.forces();
  scene.state.set(start);

  double error = 0.;
  for (unsigned int b = 0; b < motion.size(); ++b)
    error += ((high[b] - low[b]) / (2. * h) - tangent[b]).norm_square();
  return std::sqrt(error / dot(tangent, tangent));
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  deallog << std::setprecision(2);
  for (const double degrees : {0., 20., 90., 170.})
    {
      const double angle = degrees * numbers::PI / 180.;
      double       worst = 0.;
      for (const double refinement : {1., 2., 4., 8.})
        {
          ContactScene::Options options;
          options.refinement  = refinement;
          double        error = 0.;
          RandomNumbers random(5);
          for (unsigned int n = 0; n < 8; ++n)
            {
              ContactScene scene(wavy_pair(angle, 0.03, RandomNumbers(n)),
                                 {n_intervals, n_intervals},
                                 options);
              worst = std::max(worst, imbalance(scene));
              error += error_of_residual(scene, random) / 8.;
            }
          deallog << "angle " << int(degrees) << ", refinement " << refinement
                  << ": residual off by " << std::max(100. * error, 1e-3)
                  << " %" << std::endl;
        }
      deallog << "angle " << int(degrees) << ": balance "
              << (worst < 1e-9 ? "< 1e-9" : "VIOLATED") << std::endl;

      for (const double penetration : {0.2, 0.05, 0.0125})
        {
          ContactScene::Options options;
          options.refinement = 4.;
          options.threshold  = penetration;
          double error[2]    = {};
          for (const bool turn : {false, true})
            {
              RandomNumbers random(6);
              for (unsigned int n = 0; n < 8; ++n)
                {
                  ContactScene scene(
                    wavy_pair(angle, penetration, RandomNumbers(n)),
                    {n_intervals, n_intervals},
                    options);
                  scene.contact->set_geometric_stiffness(turn);
                  error[turn] += error_of_tangent(scene, random) / 8.;
                }
            }
          deallog << "angle " << int(degrees) << ", penetration " << penetration
                  << ": tangent off by " << 100. * error[0]
                  << " %, where forces turn " << 100. * error[1] << " %"
                  << std::endl;
        }
    }
}
