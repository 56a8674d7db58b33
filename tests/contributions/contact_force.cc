// The contact force of two fibers is that of the exact profile, wherever they
// cross, with long elements and with those that have sections.
#include "../contact/contact_scene.h"
#include "../tests.h"

/** A straight fiber that passes the z-axis where it is @p along long. */
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



/** The force of fibers that cross, with the penalty 1: of the profile d(s). */
double
exact_force(const double angle, const double penetration)
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



/**
 * Two straight fibers at an angle: their contact force over the integral of the
 * law along the exact profile, while the crossing is shifted to 50 places in
 * the grid of contact cells. Deviation of the mean, and the spread that a fiber
 * feels which slides over the other (the washboard), in percent: below 1.
 */
void
crossings()
{
  constexpr unsigned int n_intervals = 12;
  constexpr double       length      = 60.;
  const auto             fiber =
    [length](const double angle, const double height, const double shift) {
      return fiber_at(angle, height, 0.5 * length + shift, length);
    };
  double worst = 0.;
  deallog << std::setprecision(3);
  for (const double degrees : {90., 60., 30., 10., 5.})
    for (const double penetration : {0.005, 0.02, 0.1})
      for (const double refinement : {1., 4.})
        {
          const double          angle = degrees * numbers::PI / 180.;
          ContactScene::Options options;
          options.refinement = refinement;
          double       least = 1e300, largest = 0., sum = 0.;
          ContactScene scene(
            {fiber(0., 0., 0.), fiber(angle, 2. - penetration, 0.)},
            {n_intervals, n_intervals},
            options);
          const double exact = exact_force(angle, penetration);
          for (unsigned int k = 0; k < 50; ++k)
            {
              const double shift = 5. * k / 50.;
              scene.set_path(0, fiber(0., 0., shift), n_intervals);
              scene.set_path(
                1, fiber(angle, 2. - penetration, 0.3 * shift), n_intervals);
              scene.forces(/*search=*/true);
              const double ratio =
                scene.force_on(1)[2] /
                (exact * scene.contact->elements().front().penalty);
              least   = std::min(least, ratio);
              largest = std::max(largest, ratio);
              sum += ratio / 50.;
            }
          deallog << "angle " << degrees << ", penetration " << penetration
                  << ", refinement " << refinement << ": mean off by "
                  << 100. * (sum - 1.) << ", spread "
                  << 100. * (largest - least) / sum << std::endl;
          worst = std::max(worst, 100. * (largest - least) / sum);
        }
  deallog << "largest spread below 1 %: " << (worst < 1. ? "yes" : "NO")
          << std::endl;

  // Parallel fibers from end to end.
  for (const double penetration : {0.005, 0.02, 0.1})
    {
      ContactScene scene({fiber(0., 0., 0.), fiber(0., 2. - penetration, 0.)},
                         {n_intervals, n_intervals});
      scene.forces();
      const Heddle::Contact::NormalLaw law = {0.01};
      const double                     exact =
        law.pressure(scene.contact->elements().front().penalty, penetration) *
        length;
      deallog << "parallel, penetration " << penetration << ": force off by "
              << 100. * (scene.force_on(1)[2] / exact - 1.) << std::endl;
    }
}



constexpr unsigned int n_long = 4;

/** All places in an element of both fibers. */
void
test_long_elements(const double degrees)
{
  constexpr double penetration = 0.02;
  const double     angle       = degrees * numbers::PI / 180.;
  for (const double h : {5., 50., 100., 250., 1000., 3000.})
    {
      const double          length = n_long * h;
      ContactScene::Options options;
      ContactScene          scene(
        {fiber_at(0., 0., 0.5 * length, length),
                  fiber_at(angle, 2. - penetration, 0.5 * length, length)},
        {n_long, n_long},
        options);
      unsigned int missed = 0;
      double       worst  = 0.;
      for (unsigned int k = 0; k < 9; ++k)
        for (unsigned int l = 0; l < 9; ++l)
          {
            scene.set_path(
              0, fiber_at(0., 0., (1. + k / 8.) * h, length), n_long);
            scene.set_path(
              1,
              fiber_at(angle, 2. - penetration, (1. + l / 8.) * h, length),
              n_long);
            scene.forces(/*search=*/true);
            if (scene.contact->elements().empty())
              {
                ++missed;
                continue;
              }
            const double force =
              scene.force_on(1)[2] / scene.contact->elements().front().penalty;
            worst = std::max(
              worst, std::abs(force / exact_force(angle, penetration) - 1.));
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
                     {n_long, n_long});
  scene.parameters.search_distance = radii;
  Heddle::Contributions::FiberContact contact(scene.space, scene.parameters);
  contact.begin_step(scene.state);
  contact.update(scene.state);
  Heddle::System::Increment step(scene.state.n_local_blocks());
  for (unsigned int f = 0; f < 2; ++f)
    for (unsigned int i = 0; i <= n_long; ++i)
      step[scene.state.local_block(f) + 2 * i][2] = f == 0 ? 1. : -1.;
  const double factor = contact.searched_step(scene.state, step);
  deallog << "searched within " << radii << " radii: each may move by "
          << factor << ", and meets no axis " << (2. * factor < 2.01)
          << std::endl;
}



/**
 * Two straight fibers that cross, with elements of 5 to 3000 radii, while the
 * crossing is shifted along an element of both: there is contact wherever it
 * is, with the force of the exact profile. The search for the particles that
 * face each other begins at the middles of elements, and may have half an
 * element to go. No step lays one axis behind the other, however wide the
 * search is.
 */
void
long_elements()
{
  test_long_elements(90.);
  test_long_elements(60.);
  test_long_elements(20.);
  for (const double radii : {1., 2., 3., 4.})
    test_step(radii);
}



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



/**
 * Contact of director elements of every degree, through their smooth
 * centerline: forces and moments balance, the energy agrees with that of the C1
 * element on the same curve, and searches anew change nothing.
 */
void
director_elements()
{
  const std::vector<unsigned int> intervals = {24, 24};
  ContactScene                    smooth(wavy_pair(), intervals);
  smooth.forces();
  for (const unsigned int degree : {1, 2, 3})
    {
      ContactScene::Options options;
      options.element = "director";
      options.degree  = degree;
      ContactScene                    scene(wavy_pair(), intervals, options);
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



int
main(int argc, char **argv)
{
  const MPITest mpi(argc, argv);
  run_part("Two straight fibers that cross or run along", crossings);
  run_part("Long elements", long_elements);
  run_part("Elements with sections", director_elements);
}
