// How penalties are raised for two parallel fibers, whose penetration d is the
// same all along. At first by d over what is wanted; then by the power with
// which d followed the penalty: the same factor again if d goes like its square
// root, the largest one if d stays, the ratio itself if it goes like its
// inverse. After an accepted step what was is forgotten.
//
// Then whether energy, less what growing has brought in, grows by the work of
// the mean force in steps that multiply it.
#include "../contact/contact_scene.h"
#include "../tests.h"

constexpr unsigned int n_intervals = 8;

constexpr double threshold = 0.01, wanted = 0.75 * threshold;

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
    options.threshold = threshold;
    return options;
  }

  double
  penalty() const
  {
    return scene.contact->elements().front().penalty;
  }
};



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
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

  for (const double factor : {1., 2., 8.})
    {
      const double first = 0.05;
      Pair         pair;
      pair.accept(first);
      const double force  = pair.force();
      const double energy = pair.scene.energy() - pair.hardening();

      // At the second penetration the force is the factor times the first.
      const double shift  = 0.25 * threshold;
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
