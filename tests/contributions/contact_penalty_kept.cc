// A penalty once adapted is kept when fibers are searched anew: where they
// turn through a right angle and their orientation changes, where cells change
// their size with the angle, and where the contact slides along the fibers. One
// that a step raised in vain is taken back. Fibers that keep their orientation
// a degree beyond a right angle have that for the force of the other one:
// sqrt((1 + c) / (1 - c)) = 1.01761 times as much with the cosine c.
#include "../contact/contact_scene.h"
#include "../tests.h"

constexpr unsigned int n_intervals = 8;

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



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  examine("from 80 to 100 degrees", 80., 100., 0.);
  examine("from 100 to 80 degrees", 100., 80., 0.);
  examine("from 89 to 91 degrees", 89., 91., 0.);
  examine("from 91 to 89 degrees", 91., 89., 0.);
  examine("from 40 to 20 degrees", 40., 20., 0.);
  examine("from 20 to 40 degrees", 20., 40., 0.);
  examine("sliding by half a radius", 70., 70., 0.5);
  examine_rejection();
}
