// No fiber spins about its axis by more than 0.03, or than it moves in radii,
// along an increment: what is more is taken from all of its sections in one
// proportion. Motions without spin, fibers that spin less, and positions stay
// as they are. Fibers without sections do not spin.
#include <heddle/solver/fiber_spin.h>

#include "../contributions/scene.h"

#include <random>

constexpr unsigned int n_knots = 6;

class Fibers : public Scene
{
public:
  /** A straight fiber and one that is bent. */
  Fibers(const std::string &element)
  {
    fibers.element_kind                   = choice<Beam::ElementKind>(element);
    std::vector<Textile::FiberPath> paths = {
      straight_path(Tensor<1, 3>(), Tensor<1, 3>({3., 1., 0.}), n_knots, 0.1),
      straight_path(
        Tensor<1, 3>({0., 0., 1.}), Tensor<1, 3>({3., 0., 1.}), n_knots, 0.1)};
    for (unsigned int i = 0; i < n_knots; ++i)
      paths[1].points[i][2] += 0.05 * i * i;
    build(paths);
  }

  /** A node of a fiber by the first of its blocks. */
  unsigned int
  node(const unsigned int fiber, const unsigned int i) const
  {
    return state->local_block(fiber) + i * space->n_blocks_per_node();
  }

  /** Sections of a fiber turn by @p angles of their nodes about @p axis, or
   * about their own where there is none. */
  void
  turn(const unsigned int                         fiber,
       const std::function<double(unsigned int)> &angle,
       const Tensor<1, 3>                        &axis,
       System::Increment                         &increment) const
  {
    for (unsigned int i = 0; i < n_knots; ++i)
      {
        const unsigned int  b  = node(fiber, i);
        const Tensor<1, 3> &g1 = state->current()[b + 1],
                           &g2 = state->current()[b + 2];
        const Tensor<1, 3> about =
          axis.norm() > 0. ? axis : cross_product_3d(g1, g2);
        increment[b + 1] += angle(i) * cross_product_3d(about, g1);
        increment[b + 2] += angle(i) * cross_product_3d(about, g2);
      }
  }
};



double
largest_difference(const System::Increment &a, const System::Increment &b)
{
  double largest = 0.;
  for (unsigned int i = 0; i < a.size(); ++i)
    largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}



void
spin_of_two_fibers()
{
  const Fibers      fibers("director");
  const auto        grows = [](const unsigned int i) { return 0.4 * i; };
  const auto        less  = [](const unsigned int i) { return 0.005 * i; };
  System::Increment rest(fibers.state->n_local_blocks());

  std::mt19937                           random(3);
  std::uniform_real_distribution<double> number(-0.2, 0.2);
  for (unsigned int b = 0; b < rest.size(); b += 3)
    for (unsigned int d = 0; d < 3; ++d)
      rest[b][d] = 0.008 * number(random);

  // Sections of the first fiber tilt, too, about what lies in them.
  for (unsigned int i = 0; i < n_knots; ++i)
    {
      const unsigned int b = fibers.node(0, i);
      const Tensor<1, 3> across =
        number(random) * fibers.state->current()[b + 1] +
        number(random) * fibers.state->current()[b + 2];
      for (unsigned int k = 1; k < 3; ++k)
        rest[b + k] += cross_product_3d(across, fibers.state->current()[b + k]);
    }
  System::Increment increment = rest;
  deallog << "without spin: " << Solver::limit_spin(*fibers.state, increment)
          << ", by " << largest_difference(increment, rest) << std::endl;

  System::Increment little = rest;
  fibers.turn(1, less, Tensor<1, 3>(), little);
  increment = little;
  deallog << "spin by 0.025: " << Solver::limit_spin(*fibers.state, increment)
          << ", by " << largest_difference(increment, little) << std::endl;

  fibers.turn(0, grows, Tensor<1, 3>(), increment);
  System::Increment expected = little;
  fibers.turn(
    0,
    [&](const unsigned int i) { return 0.03 / grows(n_knots - 1) * grows(i); },
    Tensor<1, 3>(),
    expected);
  deallog << "spin by 2 of the other one: "
          << Solver::limit_spin(*fibers.state, increment)
          << ", then as if it were 0.03: "
          << (largest_difference(increment, expected) < 1e-14) << std::endl;

  // It moves by 1.5 radii.
  rest[fibers.node(0, 2)] = Tensor<1, 3>({0., 0., 0.15});
  increment               = rest;
  fibers.turn(0, grows, Tensor<1, 3>(), increment);
  expected = rest;
  fibers.turn(
    0,
    [&](const unsigned int i) { return 1.5 / grows(n_knots - 1) * grows(i); },
    Tensor<1, 3>(),
    expected);
  deallog << "moved by 1.5 radii: "
          << Solver::limit_spin(*fibers.state, increment)
          << ", then as if it were 1.5: "
          << (largest_difference(increment, expected) < 1e-14) << std::endl;
}



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  initlog();
  run_part("two fibers", spin_of_two_fibers);

  const Fibers      slender("hermite");
  System::Increment increment(slender.state->n_local_blocks());
  for (Tensor<1, 3> &motion : increment)
    motion[1] = 1.;
  deallog << "without sections: "
          << Solver::limit_spin(*slender.state, increment) << std::endl;
}
