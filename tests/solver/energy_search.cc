// Where fibers touch the solver looks at the energy: it does not go uphill, and
// no deeper into another fiber than where it begins to rise.
#include <heddle/base/choice.h>
#include <heddle/contributions/fiber_contact.h>

#include "../contributions/scene.h"

#include <sstream>

constexpr double length = 10., radius = 0.15;

/** A fiber under @p load, the last end of which moves along it by @p motion. */
void
describe_loaded(Scene             &scene,
                const std::string &element,
                const std::string &motion,
                const std::string (&load)[3])
{
  scene.fibers.element_kind =
    Heddle::choice<Heddle::Beam::ElementKind>(element);
  scene.fibers.elements_per_fiber     = 20;
  scene.fibers.material.axial_modulus = 1e4;
  for (const std::string end : {"first end", "last end"})
    {
      auto &support = scene.add_support();
      support.nodes.nodes =
        Heddle::choice<Heddle::Contributions::ChosenNodes>(end);
      support.nodes.fibers = "0";
      support.displacement = {{end == "last end" ? motion : "0", "0", "0"}};
    }
  auto &all        = scene.add_load();
  all.nodes.fibers = "0";
  all.nodes.nodes  = Heddle::Contributions::ChosenNodes::all;
  all.force        = {{load[0], load[1], load[2]}};
}



/** Another fiber, which is held, and the contact of both. */
void
build_beside_another(Scene                    &scene,
                     const Textile::FiberPath &path,
                     const Textile::FiberPath &other)
{
  scene.clamp("all", "1");
  scene.build({path, other});
  const Contact::ContactParameters contact;
  scene.contributions.push_back(
    std::make_shared<Contributions::FiberContact>(*scene.space, contact));
}



void
shorten(const std::string &element)
{
  constexpr double shortening = 0.1;
  Scene            scene;
  describe_loaded(scene,
                  element,
                  "-" + std::to_string(shortening) + "*t",
                  {"0", "1e-3", "0"});
  scene.newton.max_iterations = 200;
  const Tensor<1, 3> end({length, 0., 0.}), beside({0., 0., 2.02 * radius});
  build_beside_another(scene,
                       straight_path({}, end, 21, radius),
                       straight_path(beside, beside + end, 21, radius));

  const auto   result = scene.solve(1.);
  const double height = scene.block(0, 10)[1];

  // A flat sine of height h is longer than its chord by (pi h)^2 / 4 l. The rod
  // keeps the strain at which it buckles.
  const double buckling = std::pow(0.5 * numbers::PI * radius / length, 2.);
  const double expected =
    2. / numbers::PI *
    std::sqrt((shortening - buckling * length) * (length - shortening));
  deallog << element << ": converged " << result.converged
          << ", height over that of a sine within 1 % "
          << (std::abs(height / expected - 1.) < 0.01) << std::endl;
}



/**
 * Where a fiber is shortened far beyond its buckling load and still nearly
 * straight its tangent is not positive definite, and Newton's increment leads
 * uphill, to the unstable state. Beside another fiber, which makes the solver
 * look at the energy, it goes to the stable one: a half wave to the side to
 * which a small load pushes, whose height follows from the shortening.
 */
void
buckled_fibers()
{
  shorten("hermite");
  shorten("director");
}



/** The deepest penetration on the way, in radii, if an end moves by @p motion.
 */
double
deepest(const std::string &element, const std::string &motion)
{
  Scene scene;
  describe_loaded(scene, element, motion, {"0", "0", "-0.2*t"});
  const Tensor<1, 3> begin({-0.5 * length, 0., 2. * radius}),
    along({length, 0., 0.}), below({0., -0.5 * length, 0.}),
    across({0., length, 0.});
  build_beside_another(scene,
                       straight_path(begin, begin + along, 21, radius),
                       straight_path(below, below + across, 21, radius));
  const auto result = scene.solve(1.);

  std::istringstream words(scene.screen.str());
  std::string        word;
  double             largest = 0., value = 0.;
  while (words >> word)
    if (word == "penetration" && words >> value)
      largest = std::max(largest, value);
  deallog << element << ", an end moves by " << motion << ": converged "
          << result.converged << std::endl;
  return largest;
}



/**
 * A fiber is pushed against another one that it touches. What its ends still
 * have to move by is little beside that, and does not keep the solver from
 * looking where the energy stops falling: near where it begins. They go no
 * deeper into each other on the way than where nothing is prescribed.
 */
void
pushed_fibers()
{
  for (const std::string element : {"hermite", "director"})
    {
      const double still = deepest(element, "0");
      deallog << "  less than 0.05 R deep on the way: " << (still < 0.05)
              << std::endl;
      for (const std::string motion : {"1e-5*t", "-1e-5*t"})
        {
          const double moved = deepest(element, motion);
          deallog << "  no deeper on the way than without: "
                  << (moved < 1.1 * still) << std::endl;
        }
    }
}



int
main(int argc, char **argv)
{
  const MPITest mpi(argc, argv);
  run_part("A fiber far beyond its buckling load", buckled_fibers);
  run_part("A fiber pushed against another one", pushed_fibers);
}
