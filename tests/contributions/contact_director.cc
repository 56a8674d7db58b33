// Contact of director elements of every degree, through their smooth
// centerline: forces and moments balance, the energy agrees with that of the C1
// element on the same curve, and searches anew change nothing.
#include "../contact/contact_scene.h"
#include "../tests.h"

constexpr unsigned int n_intervals = 24;

std::vector<Path>
wavy_pair()
{
  RandomNumbers random(4);
  const Path    a = wavy_line(
    Tensor<1, 3>({-20., 0., 0.}), Tensor<1, 3>({1., 0., 0.}), 40., 0.3, random);
  const Path b = wavy_line(Tensor<1, 3>({-19., -3., 1.5}),
                           Tensor<1, 3>({0.96, 0.28, 0.}),
                           40.,
                           0.3,
                           random);
  return {a, b};
}



int
main(int argc, char **argv)
{
  MPITest      test(argc, argv);
  ContactScene smooth(wavy_pair(), {n_intervals, n_intervals});
  smooth.forces();
  for (const unsigned int degree : {1, 2, 3})
    {
      ContactScene::Options options;
      options.element = "director";
      options.degree  = degree;
      ContactScene scene(wavy_pair(), {n_intervals, n_intervals}, options);
      const std::vector<Tensor<1, 3>> forces = scene.forces();

      Tensor<1, 3> force, moment;
      double       sum = 0., on_sections = 0., change = 0.;
      for (unsigned int b = 0; b < forces.size(); ++b)
        {
          force += forces[b];
          moment += cross_product_3d(scene.state.current()[b], forces[b]);
          sum += forces[b].norm();
          on_sections += b % 3 == 0 ? 0. : forces[b].norm();
        }
      const auto &again = scene.forces(/*search=*/true);
      for (unsigned int b = 0; b < forces.size(); ++b)
        change = std::max(change, (forces[b] - again[b]).norm());
      deallog << "degree " << degree << ": balance "
              << (force.norm() < 1e-12 * sum && moment.norm() < 1e-9 * sum
                    ? "yes"
                    : "NO")
              << ", nothing on sections " << (on_sections == 0. ? "yes" : "NO")
              << ", energy off by less than 1 %: "
              << (std::abs(scene.energy() / smooth.energy() - 1.) < 0.01 ? "yes"
                                                                         : "NO")
              << ", the same again " << (change < 1e-12 * sum ? "yes" : "NO")
              << std::endl;
    }
}
