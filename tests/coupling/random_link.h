#ifndef heddle_tests_coupling_random_link_h
#define heddle_tests_coupling_random_link_h

#include <heddle/base/choice.h>
#include <heddle/coupling/link.h>
#include <heddle/system/fiber_space.h>

#include <deal.II/fe/fe_q.h>

#include "../tests.h"
#include "assemble_link.h"

#include <array>
#include <random>
#include <string>
#include <vector>


/** Element of the fiber, its degree and that of the matrix. */
struct Kind
{
  std::string  name;
  unsigned int of_fiber, of_matrix;
};

inline const std::vector<Kind> kinds = {{"hermite", 3, 1},
                                        {"hermite", 3, 2},
                                        {"director", 1, 1},
                                        {"director", 3, 2}};

inline std::string
in_words(const Kind &kind)
{
  return kind.name + ' ' + std::to_string(kind.of_fiber) + ", matrix " +
         std::to_string(kind.of_matrix);
}



/**
 * A link with the weights that a particle of a fiber and a point of a
 * hexahedron have, of blocks anywhere.
 */
class RandomLink
{
public:
  RandomLink(const Kind &kind, const unsigned int seed)
    : generator(seed)
  {
    Heddle::System::FiberSpace::Description fiber = {};
    fiber.element_lengths                         = {1.2, 0.9, 1.1, 1.4};
    const Heddle::System::FiberSpace space(
      MPI_COMM_WORLD,
      Heddle::Beam::make_element(
        Heddle::choice<Heddle::Beam::ElementKind>(kind.name), kind.of_fiber),
      {fiber});
    const auto particle = space.locate(0, 2.3 + 2. * number());
    for (unsigned int i = 0; i < particle.values.size(); ++i)
      add(particle.values[i],
          particle.blocks[i] % space.n_blocks_per_node() == 0 ? 1. : 0.);
    n_of_fiber = link.n;

    const FE_Q<3> shapes(kind.of_matrix);
    Point<3>      inside;
    for (unsigned int d = 0; d < 3; ++d)
      inside[d] = 0.5 + 0.4 * number();
    for (unsigned int a = 0; a < shapes.n_dofs_per_cell(); ++a)
      add(-shapes.shape_value(a, inside), 1.);

    link.stiffness = stiffness;
    places         = random_vectors();
  }

  Vectors
  random_vectors()
  {
    Vectors vectors(link.n);
    for (auto &vector : vectors)
      for (unsigned int d = 0; d < 3; ++d)
        vector[d] = number();
    return vectors;
  }

  /** The energy; write its gradient to @p forces. */
  double
  assemble(const Vectors       &at,
           Vectors             &forces,
           std::vector<double> *tangent = nullptr) const
  {
    return assemble_link(link, at, forces, tangent);
  }

  /** Distance of the particles of fiber and matrix. */
  Tensor<1, 3>
  distance() const
  {
    Tensor<1, 3> of_fiber, of_matrix;
    for (unsigned int a = 0; a < link.n; ++a)
      (a < n_of_fiber ? of_fiber : of_matrix) += link.weights[a] * places[a];
    return of_fiber + of_matrix;
  }

  const double           stiffness = 1.7;
  Heddle::Coupling::Link link;
  unsigned int           n_of_fiber;
  /** Part of a translation that a block takes: 0 of a tangent, else 1. */
  std::vector<double> moved;
  Vectors             places;

private:
  /** Between -1 and 1. */
  double
  number()
  {
    return 2. * generator() / generator.max() - 1.;
  }

  void
  add(const double weight, const double part)
  {
    link.weights[link.n++] = weight;
    moved.push_back(part);
  }

  std::minstd_rand generator;
};

#endif
