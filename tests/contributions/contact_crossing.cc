// Two straight fibers at an angle: their contact force over the integral of the
// law along the exact profile, while the crossing is shifted to 50 places in
// the grid of contact cells. Deviation of the mean, and the spread that a fiber
// feels which slides over the other (the washboard), in percent: below 1.
#include "../contact/contact_scene.h"
#include "../tests.h"

constexpr unsigned int n_intervals = 12;
constexpr double       length      = 60.;

/** The force of fibers whose particles part by 2 slope s from @p distance. */
double
exact_force(const double slope, const double distance, const double penalty)
{
  const Heddle::Contact::NormalLaw law   = {0.01};
  const double                     reach = slope > 0.
                                             ? std::sqrt(4. - distance * distance) / (2. * slope)
                                             : 0.5 * length;
  double                           sum   = 0.;
  const unsigned int               n     = 20000;
  for (unsigned int i = 0; i < n; ++i)
    {
      const double s = (2. * (i + 0.5) / n - 1.) * reach;
      const double d = std::hypot(distance, 2. * slope * s);
      sum += law.pressure(penalty, 2. - d) * distance / d * 2. * reach / n;
    }
  return sum;
}



Path
fiber_at(const double angle, const double height, const double shift)
{
  const Tensor<1, 3> direction({std::cos(angle), std::sin(angle), 0.});
  return line(Tensor<1, 3>({0., 0., height}) -
                (0.5 * length + shift) * direction,
              direction,
              length);
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  double  worst = 0.;
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
            {fiber_at(0., 0., 0.), fiber_at(angle, 2. - penetration, 0.)},
            {n_intervals, n_intervals},
            options);
          const double exact = exact_force(std::sin(0.5 * angle),
                                           2. - penetration,
                                           /*penalty=*/1.);
          for (unsigned int k = 0; k < 50; ++k)
            {
              const double shift = 5. * k / 50.;
              scene.set_path(0, fiber_at(0., 0., shift), n_intervals);
              scene.set_path(
                1, fiber_at(angle, 2. - penetration, 0.3 * shift), n_intervals);
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
      ContactScene scene(
        {fiber_at(0., 0., 0.), fiber_at(0., 2. - penetration, 0.)},
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
