// A section of a fiber in the matrix: its force is the derivative of its energy
// and its tangent that of the force, rigid rotations and strains of the matrix
// raise nothing, and a turned section has the sine of its angle and the moment
// that belongs to it.
#include <heddle/coupling/section_link.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/physics/transformations.h>

#include "../tests.h"
#include "assemble_link.h"

#include <cmath>
#include <random>
#include <string>
#include <vector>

using Heddle::Coupling::SectionLink;

const Tensor<1, 3> axis({2. / 3., -1. / 3., 2. / 3.});



Tensor<2, 3>
rotation(const Tensor<1, 3> &direction, const double angle)
{
  return Physics::Transformations::Rotations::rotation_matrix_3d(
    Point<3>(direction), angle);
}



/** A section between nodes of a fiber, in the midst of a hexahedron. */
struct SectionInCell
{
  SectionInCell(const unsigned int n_of_nodes, const unsigned int degree)
  {
    link.stiffness  = 1.7;
    link.weights    = {{n_of_nodes == 1 ? 1. : 0.3, 0.7}};
    link.n_of_fiber = 2 * n_of_nodes;

    // Normal to the axis, the same in all nodes.
    const Tensor<2, 3> frame = rotation(axis, 0.4);
    vectors[0] = frame * Tensor<1, 3>({1., 2., 0.}) / std::sqrt(5.);
    vectors[1] = cross_product_3d(axis, vectors[0]);
    for (unsigned int b = 0; b < link.n_of_fiber; ++b)
      places.push_back(vectors[b % 2]);

    // A cell from -1 to 1.
    const FE_Q<3>  shapes(degree);
    const Point<3> inside(0.3, 0.6, 0.45);
    for (unsigned int a = 0; a < shapes.n_dofs_per_cell(); ++a)
      {
        const Tensor<1, 3> gradient = 0.5 * shapes.shape_grad(a, inside);
        link.slopes[a] = {{gradient * vectors[0], gradient * vectors[1]}};
        places.push_back(2. * shapes.unit_support_point(a) -
                         Point<3>(1., 1., 1.));
      }
    link.n = places.size();
  }

  double
  assemble(const Vectors       &at,
           Vectors             &forces,
           std::vector<double> *tangent = nullptr) const
  {
    return assemble_link(link, at, forces, tangent);
  }

  SectionLink  link;
  Tensor<1, 3> vectors[2];
  Vectors      places;
};



const std::vector<std::pair<unsigned int, unsigned int>> kinds = {{1, 1},
                                                                  {2, 1},
                                                                  {1, 2},
                                                                  {2, 2}};

std::string
in_words(const std::pair<unsigned int, unsigned int> &kind)
{
  return "nodes " + std::to_string(kind.first) + ", matrix " +
         std::to_string(kind.second);
}



void
derivatives()
{
  for (const auto &kind : kinds)
    {
      SectionInCell    section(kind.first, kind.second);
      std::minstd_rand generator(9);
      const auto       random = [&]() {
        Vectors result(section.places.size());
        for (auto &vector : result)
          for (unsigned int d = 0; d < 3; ++d)
            vector[d] = 2. * generator() / generator.max() - 1.;
        return result;
      };
      const Vectors offset = random(), direction = random();
      const auto    at = [&](const double step) {
        Vectors result = section.places;
        for (unsigned int b = 0; b < result.size(); ++b)
          result[b] += 0.6 * offset[b] + step * direction[b];
        return result;
      };
      std::vector<double> tangent;
      Vectors             forces, before, after;
      section.assemble(at(0.), forces, &tangent);
      constexpr double h = 1e-5;
      const double     slope =
        (section.assemble(at(h), after) - section.assemble(at(-h), before)) /
        (2. * h);
      double     expected = 0., miss = 0., asymmetry = 0., size = 0.;
      const auto n = 3 * section.link.n;
      for (unsigned int i = 0; i < n; ++i)
        {
          const unsigned int b = i / 3, d = i % 3;
          expected += forces[b][d] * direction[b][d];
          double change = 0.;
          for (unsigned int j = 0; j < n; ++j)
            {
              change += tangent[i * n + j] * direction[j / 3][j % 3];
              asymmetry = std::max(
                asymmetry, std::abs(tangent[i * n + j] - tangent[j * n + i]));
            }
          size = std::max(size, std::abs(change));
          miss = std::max(
            miss, std::abs(change - (after[b][d] - before[b][d]) / (2. * h)));
        }
      deallog << in_words(kind) << ": slope "
              << (std::abs(slope / expected - 1.) < 1e-8) << ", tangent "
              << (miss < 1e-8 * size) << ", symmetric " << (asymmetry < 1e-14)
              << ", not nothing " << (size > 0.1 && std::abs(expected) > 0.01)
              << std::endl;
    }
}



/** The matrix is deformed by F, the section by Q. */
Vectors
deformed(const SectionInCell &section,
         const Tensor<2, 3>  &F,
         const Tensor<2, 3>  &Q)
{
  Vectors result = section.places;
  for (unsigned int b = 0; b < result.size(); ++b)
    result[b] = b < section.link.n_of_fiber
                  ? Q * result[b]
                  : F * result[b] + Tensor<1, 3>({5., -3., 2.});
  return result;
}



void
motions()
{
  const Tensor<1, 3> any({2. / 7., 3. / 7., -6. / 7.});
  const Tensor<2, 3> one = unit_symmetric_tensor<3>();
  // A stretch without a rotation; a matrix that turns about the axis alone.
  Tensor<2, 3> stretch({{1.2, 0.1, 0.05}, {0.1, 0.9, -0.2}, {0.05, -0.2, 1.1}});
  const Tensor<2, 3> turn = rotation(axis, 0.3);
  for (const auto &kind : kinds)
    {
      const SectionInCell section(kind.first, kind.second);
      Vectors             forces;
      const auto energy = [&](const Tensor<2, 3> &F, const Tensor<2, 3> &Q) {
        return section.assemble(deformed(section, F, Q), forces);
      };
      const Tensor<2, 3> Q = rotation(any, 0.9);
      const double       expected =
        0.5 * section.link.stiffness * std::pow(std::sin(0.3), 2);
      deallog << in_words(kind) << ": at rest " << (energy(one, one) < 1e-28)
              << ", rotated " << (energy(Q, Q) < 1e-28) << ", stretched "
              << (energy(stretch, one) < 1e-28) << ", both "
              << (energy(Q * stretch, Q) < 1e-28) << ", turned "
              << (std::abs(energy(one, turn) - expected) < 1e-12)
              << (std::abs(energy(turn, one) - expected) < 1e-12)
              << (std::abs(energy(Q, Q * turn) - expected) < 1e-12);

      // The moment on the fiber is about its axis, and the matrix has it too.
      const Vectors places = deformed(section, one, turn);
      section.assemble(places, forces);
      Tensor<1, 3> on_fiber, on_matrix, force;
      for (unsigned int b = 0; b < places.size(); ++b)
        {
          const bool is_of_fiber = b < section.link.n_of_fiber;
          (is_of_fiber ? on_fiber : on_matrix) -=
            cross_product_3d(places[b], forces[b]);
          if (!is_of_fiber)
            force += forces[b];
        }
      const double moment =
        section.link.stiffness * std::sin(0.3) * std::cos(0.3);
      deallog << ", moment " << ((on_fiber + moment * axis).norm() < 1e-12)
              << ", on the matrix " << ((on_fiber + on_matrix).norm() < 1e-12)
              << ", no force " << (force.norm() < 1e-12) << std::endl;
    }
}



int
main(int argc, char **argv)
{
  MPITest test(argc, argv);
  run_part("Derivatives", derivatives);
  run_part("Motions", motions);
}
