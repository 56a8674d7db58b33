// Penalties of contact: the first one is that of the angle of the fibers, they
// are raised until fibers penetrate as little as wanted, by as much as it takes
// but not without end, and kept while fibers move.
#include <heddle/contributions/fiber_elasticity.h>
#include <heddle/contributions/nodal_springs.h>
#include <heddle/solver/newton.h>

#include "../contact/contact_scene.h"
#include "../tests.h"

#include <sstream>

using Heddle::Contributions::NodalSprings;

constexpr unsigned int n_intervals = 8;

constexpr double grown_threshold = 0.01, wanted = 0.75 * grown_threshold;

class Pair
{
public:
  Pair()
    : scene({line_at(0.), line_at(1.98)}, {n_intervals, n_intervals}, options())
  {
    scene.forces(/*search=*/true);
  }

  /** Raise the penalty at a penetration; return the factor. */
  double
  raise(const double penetration)
  {
    scene.set_path(1, line_at(2. - penetration), n_intervals);
    scene.forces();
    const double before = penalty();
    scene.contact->adapt(scene.state);
    scene.forces();
    return penalty() / before;
  }

  /** Go to a penetration and end the step there. */
  void
  accept(const double penetration)
  {
    scene.set_path(1, line_at(2. - penetration), n_intervals);
    scene.forces();
    scene.contact->accept_step(scene.state);
  }

  double
  force() const
  {
    return scene.force_on(1)[2];
  }

  double
  hardening() const
  {
    return scene.reported("contact_hardening[N*mm]");
  }

  ContactScene scene;

private:
  static Path
  line_at(const double z)
  {
    return line(Tensor<1, 3>({0., 0., z}), Tensor<1, 3>({1., 0., 0.}), 40.);
  }

  static ContactScene::Options
  options()
  {
    ContactScene::Options options;
    options.threshold = grown_threshold;
    return options;
  }

  double
  penalty() const
  {
    return scene.contact->elements().front().penalty;
  }
};



/** The first penalty of two fibers of so many elements at an angle. */
double
first_penalty(const double degrees, const unsigned int n_elements)
{
  const double       angle = degrees * numbers::PI / 180.;
  const Tensor<1, 3> a({1., 0., 0.}), b({std::cos(angle), std::sin(angle), 0.});
  ContactScene       scene({line(-20.7 * a, a, 40.),
                            line(Tensor<1, 3>({0., 0., 1.98}) - 21.3 * b, b, 40.)},
                     {n_elements, n_elements});
  scene.forces(/*search=*/true);
  return scene.contact->elements().front().penalty;
}



/**
 * Over the first penalty of parallel fibers of the same elements, ten times the
 * sine of the angle where that is more than 1, whether elements are longer than
 * the radius or shorter.
 */
void
first()
{
  for (const unsigned int n_elements : {8, 20, 40, 80})
    {
      deallog << "elements of " << 40. / n_elements << " radii:";
      for (const double degrees : {90., 30., 10., 4.})
        deallog << ' '
                << first_penalty(degrees, n_elements) /
                     first_penalty(0., n_elements);
      deallog << " at 90, 30, 10 and 4 degrees" << std::endl;
    }
}



/**
 * How penalties are raised for two parallel fibers, whose penetration d is the
 * same all along. At first by d over what is wanted; then by the power with
 * which d followed the penalty: the same factor again if d goes like its square
 * root, the largest one if d stays, the ratio itself if it goes like its
 * inverse. After an accepted step what was is forgotten.
 */
void
growth()
{
  for (const double power : {1., 0.5, 0.})
    {
      Pair         pair;
      const double first = pair.raise(0.02);
      const double then  = 0.02 * std::pow(first, -power);
      deallog << "power " << power << ": first " << first << ", over the ratio "
              << first / (0.02 / wanted) << ", then " << pair.raise(then)
              << ", ratio " << then / wanted;
      pair.scene.contact->accept_step(pair.scene.state);
      deallog << ", after an accepted step over the ratio "
              << pair.raise(0.011) / (0.011 / wanted) << std::endl;
    }
}



/**
 * Fibers that stay as deep in each other as they are get no stiffer without
 * end, and are named.
 */
void
limit()
{
  Pair         pair;
  double       all    = 1.;
  unsigned int rounds = 0;
  for (double growth = 2.; growth > 1. && rounds < 100; ++rounds)
    all *= growth = pair.raise(0.02);
  deallog << "after " << rounds << " rounds " << all
          << " times as stiff: " << pair.scene.contact->jam_in_words()
          << std::endl;
  pair.accept(0.9 * grown_threshold);
  deallog << "less deep: " << pair.scene.contact->jam_in_words() << std::endl;
}



/**
 * Energy, less what growing penalties have brought in, grows by the work of the
 * mean force in steps that multiply it: but for the quadratic begin of the law.
 */
void
energy_of_growth()
{
  for (const double factor : {1., 2., 8.})
    {
      const double first = 0.05;
      Pair         pair;
      pair.accept(first);
      const double force  = pair.force();
      const double energy = pair.scene.energy() - pair.hardening();

      // At the second penetration the force is the factor times the first.
      const double shift  = 0.25 * grown_threshold;
      const double growth = pair.raise(0.1);
      const double second = shift + factor / growth * (first - shift);
      pair.accept(second);
      const double work = 0.5 * (force + pair.force()) * (second - first);
      deallog << "force times " << pair.force() / force
              << ": energy less what growth brought, over the work "
              << (pair.scene.energy() - pair.hardening() - energy) / work
              << std::endl;
    }
}



void
place(ContactScene &scene, const double degrees, const double shift)
{
  const double       angle = degrees * numbers::PI / 180.;
  const Tensor<1, 3> x({1., 0., 0.}), z({0., 0., 1.});
  const Tensor<1, 3> b({std::cos(angle), std::sin(angle), 0.});
  scene.set_path(0, line(-(20.7 + shift) * x, x, 40.), n_intervals);
  scene.set_path(1, line(1.98 * z - 21.3 * b, b, 40.), n_intervals);
}



/** Print the penalty after a motion over the adapted one before. */
void
examine(const std::string &name,
        const double       from,
        const double       to,
        const double       shift)
{
  ContactScene::Options options;
  options.threshold = 0.001;
  const Path   any  = line(Tensor<1, 3>(), Tensor<1, 3>({1., 0., 0.}), 40.);
  ContactScene scene({any, any}, {n_intervals, n_intervals}, options);
  place(scene, from, 0.);
  scene.forces(/*search=*/true);
  for (unsigned int n = 0; n < 3; ++n)
    {
      scene.contact->adapt(scene.state);
      scene.forces();
    }
  const double before = scene.contact->elements().front().penalty;
  place(scene, to, shift);
  scene.forces(/*search=*/true);
  const double ratio = scene.contact->elements().front().penalty / before;
  deallog << name << ": penalty over the old one " << ratio << std::endl;
}



void
examine_rejection()
{
  ContactScene::Options options;
  options.threshold = 0.001;
  const Path   any  = line(Tensor<1, 3>(), Tensor<1, 3>({1., 0., 0.}), 40.);
  ContactScene scene({any, any}, {n_intervals, n_intervals}, options);
  place(scene, 70., 0.);
  const auto penalty = [&scene]() {
    scene.forces(/*search=*/true);
    return scene.contact->elements().front().penalty;
  };
  const auto raise = [&scene]() {
    scene.contact->adapt(scene.state);
    scene.forces();
  };
  penalty();
  raise();
  const double accepted = penalty();
  scene.contact->accept_step(scene.state);
  raise();
  const bool raised = penalty() > 1.1 * accepted;
  scene.contact->reject_step(scene.state);
  deallog << "a rejected step: raised " << raised
          << ", then over the accepted one " << penalty() / accepted
          << std::endl;
}



/**
 * A penalty once adapted is kept when fibers are searched anew: where they turn
 * through a right angle and their orientation changes, where cells change their
 * size with the angle, and where the contact slides along the fibers. One that
 * a step raised in vain is taken back. Fibers that keep their orientation a
 * degree beyond a right angle have that for the force of the other one: sqrt((1
 * + c) / (1 - c)) = 1.01761 times as much with the cosine c.
 */
void
motions()
{
  examine("from 80 to 100 degrees", 80., 100., 0.);
  examine("from 100 to 80 degrees", 100., 80., 0.);
  examine("from 89 to 91 degrees", 89., 91., 0.);
  examine("from 91 to 89 degrees", 91., 89., 0.);
  examine("from 40 to 20 degrees", 40., 20., 0.);
  examine("from 20 to 40 degrees", 20., 40., 0.);
  examine("sliding by half a radius", 70., 70., 0.5);
  examine_rejection();
}



std::shared_ptr<NodalSprings>
springs()
{
  std::vector<NodalSprings::Spring> result;
  for (unsigned int f = 0; f < 2; ++f)
    for (const unsigned int node : {0u, n_intervals})
      {
        const double         s = node == 0 ? -8. : 8.;
        NodalSprings::Spring spring;
        spring.fiber  = f;
        spring.node   = node;
        spring.target = f == 0 ? Tensor<1, 3>({s - 0.7, 0., 0.})
                               : Tensor<1, 3>({0., s + 0.4, 1.});
        for (unsigned int d = 0; d < 3; ++d)
          spring.stiffness[d][d] = 1.;
        result.push_back(spring);
      }
  return std::make_shared<NodalSprings>("springs", result);
}



/** Print where Newton's method comes to by way of these aims. */
void
press(const double threshold, const std::vector<Heddle::Solver::Aim> &aims)
{
  ContactScene::Options options;
  options.threshold = threshold;
  const Tensor<1, 3> x({1., 0., 0.}), y({0., 1., 0.});
  ContactScene       scene({line(Tensor<1, 3>({-8.7, 0., 0.}), x, 16.),
                            line(Tensor<1, 3>({0., -7.6, 1.99}), y, 16.)},
                     {n_intervals, n_intervals},
                     options);
  const auto         elasticity =
    std::make_shared<Heddle::Contributions::FiberElasticity>(
      scene.space, scene.state.current());
  // Shared without owning: the scene keeps it.
  const std::shared_ptr<Heddle::System::Contribution> contact(
    scene.contact.get(), [](auto) {});
  const auto pull = springs();

  Heddle::Solver::NewtonParameters       newton_parameters;
  Heddle::Solver::LinearSolverParameters linear_parameters;
  std::ostringstream                     screen;
  Heddle::Log                            log(MPI_COMM_WORLD, screen);
  Heddle::SectionTimer                   timer;
  Heddle::StopRequest                    stop(MPI_COMM_WORLD);
  Heddle::Solver::Newton                 newton(
    newton_parameters, linear_parameters, log, timer, stop);
  elasticity->begin_step(scene.state);
  deallog << "threshold " << threshold << ":";
  for (const Heddle::Solver::Aim aim : aims)
    {
      screen.str("");
      const auto result =
        newton.solve(scene.state, {elasticity, pull, contact}, aim);
      deallog << ' ' << (result.converged ? "converged" : result.obstacle)
              << (screen.str().find("softness") == std::string::npos
                    ? ""
                    : " softly")
              << ',';
    }

  scene.forces();
  double pulled = 0.;
  for (const unsigned int node : {0u, n_intervals})
    pulled -= scene.state.fiber(1)[2 * node][2] - 1.;
  deallog << " penetration "
          << (scene.reported("max_penetration_ratio[-]") <= threshold ? "below"
                                                                      : "ABOVE")
          << ", contact force " << 1e3 * scene.force_on(1)[2]
          << "e-3, over force of springs " << -scene.force_on(1)[2] / pulled
          << std::endl;
}



/**
 * Two crossing fibers are pressed together by springs at their ends. Newton's
 * method with adapted penalties ends below the penetration threshold, however
 * tight, and the contact force is the one of the springs and tends to a limit.
 * It begins softly, far from equilibrium; having come near first, only then,
 * but always where fibers start.
 */
void
thresholds()
{
  using Heddle::Solver::Aim;
  deallog << std::setprecision(3);
  for (const double threshold : {0.05, 0.02, 0.01, 0.001})
    press(threshold, {Aim::equilibrium});
  press(0.02, {Aim::calm_from_start, Aim::equilibrium_after_calm});
  press(0.02, {Aim::calm_from_start, Aim::equilibrium_from_start});
  press(0.02, {Aim::calm_from_start, Aim::equilibrium});
  press(0.02, {Aim::equilibrium_after_calm});
}



int
main(int argc, char **argv)
{
  const MPITest mpi(argc, argv);
  run_part("First penalty", first);
  run_part("Growth", growth);
  run_part("Limit", limit);
  run_part("Energy of growth", energy_of_growth);
  run_part("Kept while fibers move", motions);
  run_part("Threshold", thresholds);
}
