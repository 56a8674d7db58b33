// A link between a fiber and the matrix: its force is the derivative of its
// energy and its tangent that of the force, both ends of it feel the same, and
// rigid motions raise nothing but what the distance at embedding does.
#include <deal.II/physics/transformations.h>

#include "random_link.h"

#include <cmath>

const Tensor<1, 3> some_offset({0.3, -0.2, 0.1});



Vectors
moved(const Vectors &places, const Vectors &direction, const double step)
{
  Vectors result = places;
  for (unsigned int b = 0; b < places.size(); ++b)
    result[b] += step * direction[b];
  return result;
}



double
product(const Vectors &forces, const Vectors &motion)
{
  double sum = 0.;
  for (unsigned int b = 0; b < forces.size(); ++b)
    sum += forces[b] * motion[b];
  return sum;
}



double
largest_difference(const Vectors &some, const Vectors &others)
{
  double largest = 0.;
  for (unsigned int b = 0; b < some.size(); ++b)
    largest = std::max(largest, (some[b] - others[b]).norm());
  return largest;
}



/** What the tangent makes of a motion by its rows or, else, by its columns. */
Vectors
raised(const std::vector<double> &tangent,
       const Vectors             &motion,
       const bool                 by_rows)
{
  const unsigned int n = 3 * motion.size();
  Vectors            forces(motion.size());
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      forces[i / 3][i % 3] +=
        tangent[by_rows ? i * n + j : j * n + i] * motion[j / 3][j % 3];
  return forces;
}



/**
 * The energy E is quadratic: forces are linear, with differences that are
 * exact, and the difference of E misses its slope by half a step times the
 * curvature that the tangent has, with the order one.
 */
void
derivatives()
{
  for (const Kind &kind : kinds)
    for (unsigned int seed = 1; seed <= 3; ++seed)
      {
        RandomLink random(kind, seed);
        random.link.offset      = some_offset;
        const Vectors direction = random.random_vectors();
        const auto    at        = [&](const double step) {
          return moved(random.places, direction, step);
        };
        std::vector<double> tangent;
        Vectors             forces, later;
        const double        energy = random.assemble(at(0.), forces, &tangent);
        const double        slope  = product(forces, direction);
        const auto          miss   = [&](const double step) {
          return (random.assemble(at(step), later) - energy) / step - slope;
        };
        const double coarse = miss(0.2), fine = miss(0.1);

        random.assemble(at(1.), later);
        const Vectors row     = raised(tangent, direction, true);
        const double  curving = product(row, direction);
        deallog << in_words(kind) << ", state " << seed
                << ": order of the residual "
                << std::round(1e6 * std::log2(coarse / fine)) / 1e6
                << ", curvature of the energy "
                << (std::abs(fine - 0.05 * curving) < 1e-12)
                << ", tangent exact "
                << (largest_difference(moved(forces, row, 1.), later) < 1e-12)
                << ", symmetric "
                << (largest_difference(row, raised(tangent, direction, false)) <
                    1e-12)
                << ", curved " << (curving > 0.01) << std::endl;
      }
}



/**
 * The link acts between the particles x of the fiber and y of the matrix: with
 * s = x - y - d_0 the energy is k s^2 / 2 and the force on the fiber -k s, on
 * the matrix as much the other way.
 */
void
particles()
{
  for (const Kind &kind : kinds)
    {
      RandomLink random(kind, /*seed=*/5);
      random.link.offset       = some_offset;
      const double       k     = random.stiffness;
      const Tensor<1, 3> s     = random.distance() - some_offset;
      const Tensor<1, 3> force = random.link.force(random.places.data());
      Vectors            gradient;
      const double       energy = random.assemble(random.places, gradient);
      Tensor<1, 3>       on_fiber, on_matrix;
      for (unsigned int a = 0; a < gradient.size(); ++a)
        (a < random.n_of_fiber ? on_fiber : on_matrix) -=
          random.moved[a] * gradient[a];
      deallog << in_words(kind) << ": " << random.link.n
              << " weights, stretched " << (s.norm() > 0.1) << ", as expected "
              << ((random.link.stretch(random.places.data()) - s).norm() <
                  1e-12)
              << ", energy "
              << (std::abs(energy - 0.5 * k * s.norm_square()) < 1e-12)
              << ", force " << ((force + k * s).norm() < 1e-12)
              << ", on the fiber " << ((on_fiber - force).norm() < 1e-12)
              << ", on the matrix " << ((on_matrix + force).norm() < 1e-12)
              << std::endl;
    }
}



/** Sum of all blocks times their forces: the moment, that of tangents too. */
Tensor<1, 3>
moment(const Vectors &places, const Vectors &forces)
{
  Tensor<1, 3> sum;
  for (unsigned int a = 0; a < places.size(); ++a)
    sum += cross_product_3d(places[a], forces[a]);
  return sum;
}



/**
 * A translation changes nothing. A rotation R keeps the energy and turns the
 * forces, which have no moment, where the particles met at embedding. Else d_0
 * does not turn: with the distance d and s = d - d_0 the moment of the gradient
 * is k d_0 x s, and the energy becomes k |R d - d_0|^2 / 2.
 */
void
rigid_motions()
{
  const Tensor<2, 3> rotation =
    Physics::Transformations::Rotations::rotation_matrix_3d(
      Point<3>(2. / 3., -1. / 3., 2. / 3.), /*angle=*/0.9);
  for (const Kind &kind : kinds)
    for (const bool met : {true, false})
      {
        RandomLink random(kind, /*seed=*/9);
        random.link.offset = met ? Tensor<1, 3>() : some_offset;
        Vectors      forces, when_carried, when_turned;
        const double energy = random.assemble(random.places, forces);

        Vectors carried = random.places, turned = random.places;
        Vectors turned_forces = forces;
        for (unsigned int a = 0; a < carried.size(); ++a)
          {
            carried[a] += random.moved[a] * Tensor<1, 3>({5., -3., 2.});
            turned[a]        = rotation * turned[a];
            turned_forces[a] = rotation * forces[a];
          }
        const double       of_carried = random.assemble(carried, when_carried);
        const double       of_turned  = random.assemble(turned, when_turned);
        const double       k          = random.stiffness;
        const Tensor<1, 3> d = random.distance(), d_0 = random.link.offset;
        const double       expected_energy =
          0.5 * k * (rotation * d - d_0).norm_square();
        const Tensor<1, 3> found = moment(random.places, forces);
        deallog << in_words(kind) << (met ? ", met" : ", apart") << ": carried "
                << (std::abs(of_carried - energy) < 1e-12)
                << (largest_difference(when_carried, forces) < 1e-12)
                << ", turned: energy kept "
                << (std::abs(of_turned - energy) < 1e-12) << ", as expected "
                << (std::abs(of_turned - expected_energy) < 1e-12)
                << ", forces turn "
                << (largest_difference(when_turned, turned_forces) < 1e-12)
                << ", moment " << (found.norm() > 1e-12) << ", as expected "
                << ((found - k * cross_product_3d(d_0, d - d_0)).norm() < 1e-12)
                << std::endl;
      }
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  run_part("Derivatives", derivatives);
  run_part("Particles", particles);
  run_part("Rigid motions", rigid_motions);
}
