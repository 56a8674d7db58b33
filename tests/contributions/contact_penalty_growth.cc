// How penalties are raised for two parallel fibers, whose penetration d is the
// same all along. At first by d over what is wanted; then by the power with
// which d followed the penalty: the same factor again if d goes like its square
// root, the largest one if d stays, the ratio itself if it goes like its
// inverse. After an accepted step what was is forgotten.
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
}
