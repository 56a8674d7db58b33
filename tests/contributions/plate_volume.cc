// The fiber volume fraction between plates counts the length of axes inside of
// what they cover, as it is: all of a fiber, the half of one that ends amid it,
// a fiber aslant, one on an arc that passes a side, and one that is stretched;
// nothing of a fiber beside it, or above the plates. On any number of ranks.
#include <heddle/contributions/plates.h>
#include <heddle/contributions/volume_in_box.h>

#include "../contact/contact_scene.h"
#include "../tests.h"

using Heddle::Contributions::Plates;

const double pi = numbers::PI;

/** Length of the axes in a box about the origin, 20 by 10 and @p height. */
double
length_inside(const std::vector<Path> &paths, const double height = 8.)
{
  const ContactScene scene(paths, std::vector<unsigned int>(paths.size(), 16));
  const BoundingBox<3> box(
    {Point<3>(-10., -5., -0.5 * height), Point<3>(10., 5., 0.5 * height)});
  return Utilities::MPI::sum(
           Heddle::Contributions::volume_in_box(scene.state, box),
           MPI_COMM_WORLD) /
         pi;
}



void
lengths()
{
  const Tensor<1, 3> x({1., 0., 0.}), z({0., 0., 1.});
  const Tensor<1, 3> aslant({std::cos(0.3), std::sin(0.3), 0.});
  deallog << "through it " << length_inside({line(-20. * x, x, 40.)}) / 20.
          << ", half of it " << length_inside({line(0. * x, x, 40.)}) / 10.
          << ", aslant through two opposite sides "
          << length_inside({line(-20. * aslant, aslant, 40.)}) /
               (20. / std::cos(0.3))
          << std::endl;
  const Tensor<1, 3> beside({-20., 5.1, 0.}), above({-20., 0., 4.1});
  deallog << "beside " << length_inside({line(beside, x, 40.)}) << ", above "
          << length_inside({line(above, x, 40.)}) << ", upright "
          << length_inside({line(-20. * z, z, 40.)}) / 8. << std::endl;

  // The angle at which a circle of radius 20 about (0, 0, -20) passes x = 10.
  const Path arc = [](const double t) {
    const double angle = (t - 0.5) * 2.;
    return Tensor<1, 3>(
      {20. * std::sin(angle), 0., 20. * (std::cos(angle) - 1.)});
  };
  const double exact = 2. * 20. * std::asin(0.5);
  const double error = length_inside({arc}) / exact - 1.;
  std::cout << "error of an arc " << error << std::endl;
  deallog << "an arc is right to 1e-5: " << (std::abs(error) < 1e-5)
          << std::endl;
  deallog << "all of them "
          << length_inside({line(-20. * x, x, 40.),
                            line(0. * x, x, 40.),
                            line(beside, x, 40.)}) /
               30.
          << std::endl;
}



/**
 * Three fibers of length 40 along x, of which one ends amid the plates, that
 * are then drawn out by a tenth about the origin, between plates of area 20 by
 * 10 that go from the distance 2 to 1.8.
 */
void
fraction()
{
  const Tensor<1, 3> x({1., 0., 0.});
  ContactScene       scene({line(Tensor<1, 3>({-20., -2.5, 0.}), x, 40.),
                            line(Tensor<1, 3>({-20., 2.5, 0.}), x, 40.),
                            line(Tensor<1, 3>({-40., 0., 0.}), x, 40.)},
                     {16, 16, 16});
  Heddle::Contributions::PlateParameters parameters;
  parameters.compression = "0.1*t";
  Plates     plates(scene.space,
                parameters,
                0.02,
                BoundingBox<2>({Point<2>(-10., -5.), Point<2>(10., 5.)}));
  const auto fraction = [&]() {
    std::map<std::string, double> values;
    plates.report(scene.state, values);
    return values.at("plate_volume_fraction[-]");
  };
  deallog << "nowhere yet: "
          << (std::isnan(fraction()) ? "nothing" : "SOMETHING") << std::endl;
  plates.begin_stage(scene.state);
  deallog << "at first " << fraction() / (50. * pi / 400.) << std::endl;
  scene.state.load_factor = 1.;
  plates.update(scene.state);
  plates.accept_step(scene.state);
  deallog << "nearer " << fraction() / (50. * pi / 360.) << std::endl;

  // Longer, so that the same length is inside; the third fiber's end moves out.
  scene.set_path(2, line(Tensor<1, 3>({-49., 0., 0.}), x, 44.), 16);
  deallog << "one drawn out " << fraction() / (45. * pi / 360.) << std::endl;
}



int
main(int argc, char **argv)
{
  const MPITest mpi(argc, argv);
  run_part("Lengths", lengths);
  run_part("Volume fraction", fraction);
}
