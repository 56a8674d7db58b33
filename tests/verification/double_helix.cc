// Two straight rods, side by side, are stretched and twisted into a double
// helix of one turn. The force per length by which they press on each other has
// a closed form (Meier, Popp, Wall, 2016), p0 (1 - d / 2 R) to first order in
// the penetration d: it converges with the threshold to p0, and is the same all
// along. The axial stiffness is such that the element, whose strain is that of
// Green and Lagrange, has the axial force of the closed form.
#include <heddle/contributions/fiber_contact.h>

#include "../contributions/scene.h"

#include <iomanip>

const double radius = 0.0095, length = 5., stretch = 1.01;
const double axial_force = 3141.5927, bending = 7.8539816;
const double closed_form = 46.8452798;



/** Both rods, held at the bottom, stretched and twisted at the top. */
void
describe(Scene &scene, const unsigned int n_elements)
{
  scene.fibers.axial_modulus = 1e9;
  scene.fibers.poisson_ratio = 0.;
  scene.fibers.axial_stiffness =
    axial_force / (stretch * 0.5 * (stretch * stretch - 1.));
  scene.fibers.bending_stiffness = bending;
  scene.newton.max_iterations    = 100;
  scene.newton.damping           = 0.;
  auto &bottom                   = scene.add_support();
  bottom.nodes.nodes             = "first end";
  bottom.displacement            = {{"0", "0", "0"}};
  bottom.held_tangent            = {"x"};
  auto &top                      = scene.add_support();
  top.nodes.nodes                = "last end";
  top.displacement = {{"x*(cos(2*pi*t)-1)", "x*sin(2*pi*t)", "0.0496472226*t"}};
  top.held_tangent = {"x"};
  std::vector<Textile::FiberPath> paths;
  for (const double x : {-radius, radius})
    paths.push_back(straight_path(Tensor<1, 3>({x, 0., 0.}),
                                  Tensor<1, 3>({x, 0., length}),
                                  n_elements + 1,
                                  radius));
  scene.build(paths);
}



/** Error of the contact force per length; @p before is that of another run. */
double
test(const unsigned int n_elements,
     const double       threshold,
     const double       before,
     const double       allowed)
{
  Contact::ContactParameters contact;
  contact.threshold = threshold;
  Scene scene;
  describe(scene, n_elements);
  const auto touch =
    std::make_shared<Contributions::FiberContact>(*scene.space, contact);
  scene.contributions.push_back(touch);
  const unsigned int n_steps   = 16;
  bool               converged = true;
  for (unsigned int step = 1; step <= n_steps && converged; ++step)
    converged = scene.solve(double(step) / n_steps).converged;

  double force = 0., weight = 0., least = 1e9, most = 0.;
  for (const auto &element : touch->elements())
    if (std::abs(element.s_a - 0.5 * length) < 0.25 * length)
      {
        force += element.force;
        weight += element.weight;
        least = std::min(least, element.force / element.weight);
        most  = std::max(most, element.force / element.weight);
      }
  const double error = force / weight / closed_form - 1.;
  deallog << "elements " << n_elements << ", threshold " << threshold
          << ": converged " << converged << std::setprecision(3)
          << ", force per length " << force / weight << ", error "
          << 100. * error << " %";
  if (before != 0.)
    deallog << ", order " << std::round(10. * std::log2(before / error)) / 10.;
  deallog << ", scatter along the middle half "
          << std::round(1000. * (most - least) / closed_form) / 10. << " %"
          << verdict(converged && std::abs(error) < allowed) << std::endl;
  return error;
}



int
main(int argc, char **argv)
{
  MPITest mpi(argc, argv);
  double  error = 0.;
  for (const double threshold : {0.02, 0.01})
    error = test(/*n_elements=*/16, threshold, error, /*allowed=*/6e-3);
  for (const unsigned int n_elements : {4, 8, 32})
    test(n_elements, /*threshold=*/0.01, 0., n_elements == 4 ? 3e-2 : 5e-3);
}
