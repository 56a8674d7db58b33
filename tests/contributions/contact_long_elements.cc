// Two straight fibers that cross, with elements of 5 to 3000 radii, while the
// crossing is shifted along an element of both: there is contact wherever it
// is, with the force of the exact profile. The search for the particles that
// face each other begins at the middles of elements, and may have half an
// element to go. No step lays one axis behind the other, however wide the
// search is.
#include "../contact/contact_scene.h"
#include "../tests.h"

constexpr unsigned int n_intervals = 4;
constexpr double       penetration = 0.02;



Path
fiber_at(const double angle,
         const double height,
         const double along,
         const double length)
{
  const Tensor<1, 3> direction({std::cos(angle), std::sin(angle), 0.});
  return line(
    Tensor<1, 3>({0., 0., height}) - along * direction, direction, length);
}



/** The force of the profile d(s), with the penalty 1. */
double
exact_force(const double angle)
{
  const Heddle::Contact::NormalLaw law      = {0.01};
  const double                     slope    = std::sin(0.5 * angle);
  const double                     distance = 2. - penetration;
  const double       reach = std::sqrt(4. - distance * distance) / (2. * slope);
  double             sum   = 0.;
  const unsigned int n     = 20000;
  for (unsigned int i = 0; i < n; ++i)
    {
      const double s = (2. * (i + 0.5) / n - 1.) * reach;
      const double d = std::hypot(distance, 2. * slope * s);
      sum += law.pressure(1., 2. - d) * distance / d * 2. * reach / n;
    }
  return sum;
}



void
test(const double degrees)
{
  const double angle = degrees * numbers::PI / 180.;
  for (const double h : {5., 50., 100., 250., 1000., 3000.})
    {
      const double          length = n_intervals * h;
      ContactScene::Options options;
      ContactScene          scene(
        {fiber_at(0., 0., 0.5 * length, length),
                  fiber_at(angle, 2. - penetration, 0.5 * length, length)},
        {n_intervals, n_intervals},
        options);
      unsigned int missed = 0;
      double       worst  = 0.;
      for (unsigned int k = 0; k < 9; ++k)
        for (unsigned int l = 0; l < 9; ++l)
          {
            scene.set_path(
              0, fiber_at(0., 0., (1. + k / 8.) * h, length), n_intervals);
            scene.set_path(
              1,
              fiber_at(angle, 2. - penetration, (1. + l / 8.) * h, length),
              n_intervals);
            scene.forces(/*search=*/true);
            if (scene.contact->elements().empty())
              {
                ++missed;
                continue;
              }
            const double force =
              scene.force_on(1)[2] / scene.contact->elements().front().penalty;
            worst = std::max(worst, std::abs(force / exact_force(angle) - 1.));
          }
      std::cout << degrees << " degrees, h " << h << ": " << worst << std::endl;
      deallog << degrees << " degrees, elements of " << h << " radii: missed "
              << missed << " of 81, off by less than 1 %: " << (worst < 0.01)
              << std::endl;
    }
}



/** Fibers that touch and are to go the other one's way. */
void
test_step(const double radii)
{
  ContactScene scene({fiber_at(0., 0., 10., 20.), fiber_at(1., 2.01, 10., 20.)},
                     {n_intervals, n_intervals});
  scene.parameters.search_distance = radii;
  Heddle::Contributions::FiberContact contact(scene.space, scene.parameters);
  contact.begin_step(scene.state);
  contact.update(scene.state);
  Heddle::System::Increment step(scene.state.n_local_blocks());
  for (unsigned int f = 0; f < 2; ++f)
    for (unsigned int i = 0; i <= n_intervals; ++i)
      step[scene.state.local_block(f) + 2 * i][2] = f == 0 ? 1. : -1.;
  const double factor = contact.largest_step(scene.state, step);
  deallog << "searched within " << radii << " radii: each may move by "
          << factor << ", and meets no axis " << (2. * factor < 2.01)
          << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  test(90.);
  test(60.);
  test(20.);
  for (const double radii : {1., 2., 3., 4.})
    test_step(radii);
}
