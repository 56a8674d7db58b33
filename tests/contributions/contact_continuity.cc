// The contact force is continuous however two fibers pass each other: when a
// crossing slides, when the angle passes a right angle or becomes parallel,
// when an end slides past a side or another end, in a loop of one fiber. With
// four times as many steps the largest change in one step is a fourth of what
// it was; a jump would stay. What quadrature leaves at a right angle, where the
// two orientations change places, is below 0.2 %. Contact is searched anew in
// every step.
#include "../contact/contact_scene.h"
#include "../tests.h"

#include <functional>

/** Bring the fibers of a scene to a place of their path, from 0 to 1. */
using Sweep = std::function<void(ContactScene &, double)>;

const Tensor<1, 3> x_axis({1., 0., 0.});
const Tensor<1, 3> z_axis({0., 0., 1.});

Tensor<1, 3>
in_plane(const double angle)
{
  return Tensor<1, 3>({std::cos(angle), std::sin(angle), 0.});
}



/** Largest change of the force on the last fiber in one step over the force. */
double
largest_change(const unsigned int n_fibers,
               const unsigned int n_intervals,
               const unsigned int n_steps,
               const Sweep       &sweep,
               const Path        &start)
{
  const std::vector<unsigned int> intervals(n_fibers, n_intervals);
  ContactScene scene(std::vector<Path>(n_fibers, start), intervals);
  double       size = 0., largest = 0.;
  std::vector<Tensor<1, 3>> last;
  for (unsigned int k = 0; k <= n_steps; ++k)
    {
      sweep(scene, double(k) / n_steps);
      const auto forces = scene.forces(/*search=*/true);
      double     change = 0., sum = 0.;
      for (unsigned int b = 0; b < forces.size(); b += 2)
        {
          sum += forces[b].norm();
          change += k > 0 ? (forces[b] - last[b]).norm() : 0.;
        }
      size    = std::max(size, sum);
      largest = std::max(largest, change);
      last    = forces;
    }
  return largest / size;
}



void
examine(const std::string &name,
        const unsigned int n_fibers,
        const unsigned int n_intervals,
        const Sweep       &sweep,
        const Path        &start = line(Tensor<1, 3>(), x_axis, 40.))
{
  const double coarse = largest_change(n_fibers, n_intervals, 60, sweep, start);
  const double fine = largest_change(n_fibers, n_intervals, 240, sweep, start);
  // A jump J beside a steady change: coarse = J + C, fine = J + C / 4.
  const double jump = (4. * fine - coarse) / 3.;
  deallog << name << ": "
          << (coarse > 0. && jump < 3e-3 * coarse + 2e-3 ? "continuous"
                                                         : "JUMPS")
          << std::endl;
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  deallog << std::setprecision(3);
  constexpr unsigned int n = 8;

  for (const double degrees : {90., 50., 20., 8.})
    examine("crossing of " + std::to_string(int(degrees)) + " degrees slides",
            2,
            n,
            [&](ContactScene &scene, const double t) {
              const auto b = in_plane(degrees * numbers::PI / 180.);
              scene.set_path(0, line((-20. - 6. * t) * x_axis, x_axis, 40.), n);
              scene.set_path(
                1, line(1.985 * z_axis - (20. + 2. * t) * b, b, 40.), n);
            });
  const auto turn = [&](const double from, const double to) {
    return [from, to](ContactScene &scene, const double t) {
      const auto b = in_plane((from + (to - from) * t) * numbers::PI / 180.);
      scene.set_path(0, line(-20.7 * x_axis, x_axis, 40.), n);
      scene.set_path(1, line(1.985 * z_axis - 21.3 * b, b, 40.), n);
    };
  };
  examine("angle from 80 to 100", 2, n, turn(80., 100.3));
  examine("angle from 99 to 81", 2, n, turn(99., 80.7));
  examine("angle from 85 to 25", 2, n, turn(85., 25.));
  examine("angle from 25 to 5", 2, n, turn(25., 5.));
  examine("angle from 5 to -5", 2, n, turn(5., -5.));
  examine("angle from 155 to 175", 2, n, turn(155., 175.));

  examine(
    "end slides along a side", 2, n, [&](ContactScene &scene, const double t) {
      scene.set_path(0, line(Tensor<1, 3>(), x_axis, 40.), n);
      scene.set_path(
        1, line(Tensor<1, 3>({-38.5 + 13. * t, 0., 1.985}), x_axis, 40.), n);
    });
  examine(
    "end slides past an end", 2, n, [&](ContactScene &scene, const double t) {
      scene.set_path(0, line(Tensor<1, 3>(), x_axis, 40.), n);
      scene.set_path(
        1, line(Tensor<1, 3>({38. + 6. * t, 0.3, 1.95}), x_axis, 40.), n);
    });
  examine("end meets an end", 2, n, [&](ContactScene &scene, const double t) {
    scene.set_path(0, line(Tensor<1, 3>(), x_axis, 40.), n);
    scene.set_path(
      1, line(Tensor<1, 3>({42.1 - 0.2 * t, 0., 0.}), x_axis, 40.), n);
  });
  examine("end on a side", 2, n, [&](ContactScene &scene, const double t) {
    scene.set_path(0, line(Tensor<1, 3>(), x_axis, 40.), n);
    scene.set_path(
      1, line(Tensor<1, 3>({36. + 6. * t, 0., 1.95}), z_axis, 40.), n);
  });
  examine(
    "end leaves a crossing", 2, n, [&](ContactScene &scene, const double t) {
      scene.set_path(0, line(Tensor<1, 3>(), x_axis, 40.), n);
      scene.set_path(1,
                     line(Tensor<1, 3>({20.3, -38. - 4. * t, 1.95}),
                          in_plane(0.5 * numbers::PI),
                          40.),
                     n);
    });
  const auto loop = [](const double rise) {
    return [rise](const double t) {
      const double angle = 8. * t - 4.;
      return Tensor<1, 3>({3. * angle - 8. * std::sin(angle),
                           -8. * std::cos(angle),
                           rise * angle});
    };
  };
  examine(
    "loop of one fiber closes",
    1,
    24,
    [&](ContactScene &scene, const double t) {
      scene.set_path(0, loop(0.468 - 0.025 * t), 24);
    },
    loop(0.468));
}
