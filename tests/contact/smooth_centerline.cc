// The smooth centerline of every element, on uneven meshes: weights of a
// material point sum to one, quadratic curves are reproduced (cubic ones by the
// C1 element), the slope has no jump at nodes, and the knots that contact sees
// are the same curve, also those of any piece of which a rank knows the nodes.
#include <heddle/base/choice.h>
#include <heddle/contact/curve.h>
#include <heddle/system/fiber_space.h>

#include "../tests.h"
#include "knots.h"

#include <limits>

using Heddle::System::FiberSpace;

/** A curve of some degree in s, and its slope. */
Tensor<1, 3>
monomials(const double s, const unsigned int degree)
{
  return Tensor<1, 3>(
    {s, degree > 1 ? s * s / 8. : 1., degree > 2 ? s * s * s / 64. : -s});
}



Tensor<1, 3>
slopes(const double s, const unsigned int degree)
{
  return Tensor<1, 3>(
    {1., degree > 1 ? s / 4. : 0., degree > 2 ? 3. * s * s / 64. : -1.});
}



struct Errors
{
  double sum = 0., curve = 0., kink = 0., knots = 0.;

  /** Knots of pieces that are not those of the whole fiber. */
  unsigned int wrong = 0;
};



Tensor<1, 3>
position(const FiberSpace                &space,
         const std::vector<Tensor<1, 3>> &blocks,
         const double                     s)
{
  const auto   point = space.locate(0, s);
  Tensor<1, 3> x;
  for (unsigned int i = 0; i < 4; ++i)
    x += point.values[i] * blocks[point.blocks[i]];
  return x;
}



/** Count knots that differ where no more than a piece is known. */
unsigned int
count_wrong_knots(const FiberSpace                &space,
                  const std::vector<Tensor<1, 3>> &blocks,
                  const std::vector<Tensor<1, 3>> &positions,
                  const std::vector<Tensor<1, 3>> &tangents)
{
  const unsigned int n = space.fiber(0).n_nodes, m = space.n_blocks_per_node();
  unsigned int       n_wrong = 0;
  for (unsigned int begin = 0; begin < n; ++begin)
    for (unsigned int end = begin + 1; end <= n; ++end)
      {
        Tensor<1, 3> unknown;
        unknown[0] = std::numeric_limits<double>::quiet_NaN();
        std::vector<Tensor<1, 3>> known(blocks.size(), unknown);
        std::copy(blocks.begin() + m * begin,
                  blocks.begin() + m * end,
                  known.begin() + m * begin);
        const auto                knots = space.knots_from(0, {begin, end});
        std::vector<Tensor<1, 3>> x(knots.end - knots.begin), t(x);
        space.centerline_knots(
          0, {begin, end}, known.data() + m * begin, x.data(), t.data());
        for (unsigned int i = knots.begin; i < knots.end; ++i)
          n_wrong += x[i - knots.begin] == positions[i] &&
                         t[i - knots.begin] == tangents[i]
                       ? 0
                       : 1;
      }
  return n_wrong;
}



Errors
examine(const std::string &name,
        const unsigned int degree,
        const unsigned int n_elements,
        const unsigned int curve_degree,
        RandomNumbers     &random)
{
  FiberSpace::Description fiber;
  for (unsigned int e = 0; e < n_elements; ++e)
    fiber.element_lengths.push_back(random.between(0.4, 2.));
  fiber.radius    = 1.;
  fiber.yarn_id   = 0;
  fiber.bundle_id = 0;
  fiber.section   = Heddle::Beam::circular_section(1., 1., 0.4, 0.25);
  const FiberSpace space(
    MPI_COMM_WORLD,
    Heddle::Beam::make_element(Heddle::choice<Heddle::Beam::ElementKind>(name),
                               degree),
    {fiber});

  const unsigned int        per_node = space.n_blocks_per_node();
  const unsigned int        n_nodes  = space.fiber(0).n_nodes;
  const double             *s_nodes  = space.node_positions(0);
  std::vector<Tensor<1, 3>> exact(space.n_blocks(0)), random_curve(exact);
  for (unsigned int i = 0; i < n_nodes; ++i)
    {
      exact[per_node * i] = monomials(s_nodes[i], curve_degree);
      if (per_node == 2)
        exact[per_node * i + 1] = slopes(s_nodes[i], curve_degree);
      for (unsigned int b = 0; b < per_node; ++b)
        random_curve[per_node * i + b] = random.direction();
    }

  Errors                    errors;
  std::vector<Tensor<1, 3>> positions(n_nodes), tangents(n_nodes);
  space.centerline_knots(0,
                         space.all_nodes(0),
                         random_curve.data(),
                         positions.data(),
                         tangents.data());
  errors.wrong = count_wrong_knots(space, random_curve, positions, tangents);
  std::vector<Heddle::Contact::CurveCubic> cubics(n_nodes);
  Heddle::Contact::set_cubics(
    n_nodes, s_nodes, positions.data(), tangents.data(), cubics.data());
  const Heddle::Contact::Curve curve(n_nodes,
                                     {0, n_nodes},
                                     s_nodes,
                                     positions.data(),
                                     tangents.data(),
                                     cubics.data(),
                                     1.);
  unsigned int                 hint = 0;
  for (unsigned int k = 0; k <= 200; ++k)
    {
      const double s     = space.fiber(0).length * k / 200.;
      const auto   point = space.locate(0, s);
      double       sum   = -1.;
      for (unsigned int i = 0; i < 4; ++i)
        sum += point.blocks[i] % per_node == 0 ? point.values[i] : 0.;
      errors.sum   = std::max(errors.sum, std::abs(sum));
      errors.curve = std::max(
        errors.curve,
        (position(space, exact, s) - monomials(s, curve_degree)).norm());
      errors.knots = std::max(
        errors.knots,
        (position(space, random_curve, s) - curve.evaluate(s, hint).position)
          .norm());
    }
  for (unsigned int i = 1; i + 1 < n_nodes; ++i)
    {
      const double       h = 1e-7;
      const Tensor<1, 3> kink =
        (position(space, random_curve, s_nodes[i] + h) +
         position(space, random_curve, s_nodes[i] - h) -
         2. * position(space, random_curve, s_nodes[i])) /
        h;
      errors.kink = std::max(errors.kink, kink.norm());
    }
  return errors;
}



int
main(int argc, char **argv)
{
  MPITest       test(argc, argv);
  RandomNumbers random(7);
  const auto    verdict = [](const double value, const double tolerance) {
    return value < tolerance ? "yes" : "NO";
  };
  for (const unsigned int degree : {0, 1, 2, 3})
    for (const unsigned int n_elements : {1, 2, 3, 12})
      {
        const std::string  name = degree == 0 ? "hermite" : "director";
        const unsigned int reproduced =
          degree == 0 ? 3 : (degree * n_elements == 1 ? 1 : 2);
        const Errors errors =
          examine(name, std::max(1u, degree), n_elements, reproduced, random);
        deallog << name << ' ' << degree << ", elements " << n_elements
                << ": sum one " << verdict(errors.sum, 1e-12) << ", degree "
                << reproduced << " reproduced " << verdict(errors.curve, 1e-10)
                << ", smooth " << verdict(errors.kink, 1e-3)
                << ", knots the same " << verdict(errors.knots, 1e-11)
                << ", of pieces too " << verdict(errors.wrong, 0.5)
                << std::endl;
      }
}
