#ifndef heddle_tests_system_random_terms_h
#define heddle_tests_system_random_terms_h

#include <heddle/system/block_system.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/physics/transformations.h>

#include "small_scene.h"

#include <algorithm>

using Numbers = std::vector<double>;
using Blocks  = std::vector<unsigned int>;

/**
 * Terms of a tangent between blocks of a scene drawn at random, the same on all
 * ranks, and their dense sum. Blocks have their identities here.
 */
class RandomTerms
{
public:
  /** Residual, and tangent by rows. */
  struct Element
  {
    Blocks  blocks;
    Numbers residual, tangent;
  };

  /** See System::PairCouplings. */
  struct Pair
  {
    Blocks                blocks;
    Numbers               weights;
    SymmetricTensor<2, 3> stiffness;
  };

  /** See System::UnsymmetricTerms: a vector and its weights of two blocks. */
  struct Weighted
  {
    Tensor<1, 3> vector;
    Blocks       blocks;
    Numbers      weights;
  };

  RandomTerms(const unsigned int n_blocks)
    : forces(n_blocks)
    , symmetric(3 * n_blocks)
    , unsymmetric(3 * n_blocks)
  {
    for (const unsigned int n : {1, 2, 2, 4, 4, 5, 6, 6, 31})
      elements.push_back(draw_element(draw_blocks(n)));
    Blocks repeated = draw_blocks(4);
    repeated.push_back(repeated[1]);
    elements.push_back(draw_element(repeated));
    for (const Element &element : elements)
      add(element);

    rows = draw_element(draw_blocks(5));
    std::fill(rows.residual.begin(), rows.residual.end(), 0.);
    add(rows);
    for (unsigned int b = 0; b < n_blocks; ++b)
      {
        diagonal.push_back(number());
        for (unsigned int d = 0; d < 3; ++d)
          symmetric(3 * b + d, 3 * b + d) += diagonal[b];
      }
    for (unsigned int k = 0; k < 3; ++k)
      {
        axes.push_back(draw_pair(8));
        add(element_of(axes.back()));
        sections.push_back(draw_pair(16));
        add(element_of(sections.back()));
        motions.push_back(draw_weighted());
        loads.push_back({{draw_weighted(), draw_weighted()}});
        for (const Weighted &load : loads.back())
          add_unsymmetric(motions.back(), load);
      }
  }

  /** The tangent that a pair adds: w_i w_j k between its sides. */
  static Element
  element_of(const Pair &pair)
  {
    const unsigned int n = pair.blocks.size();
    Element element{pair.blocks, Numbers(3 * n, 0.), Numbers(9 * n * n, 0.)};
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        if ((i < n / 2) != (j < n / 2))
          for (unsigned int d = 0; d < 3; ++d)
            for (unsigned int e = 0; e < 3; ++e)
              element.tangent[(3 * i + d) * 3 * n + 3 * j + e] =
                pair.weights[i] * pair.weights[j] * pair.stiffness[d][e];
    return element;
  }

  /** Some components in frames of their own on a third of all blocks. */
  std::vector<System::Constraint>
  draw_constraints()
  {
    std::vector<System::Constraint> result;
    for (unsigned int b = 0; b < forces.size(); b += 3)
      {
        const Tensor<1, 3> axis = draw_vector();
        const Tensor<2, 3> frame =
          Physics::Transformations::Rotations::rotation_matrix_3d(
            Point<3>(axis / axis.norm()), 3. * number());
        result.push_back({b,
                          {{b % 2 == 0, b % 4 > 1, b % 5 > 1}},
                          frame,
                          {{number(), number(), number()}}});
      }
    return result;
  }

  Vectors
  draw_vectors()
  {
    Vectors result(forces.size());
    for (Tensor<1, 3> &vector : result)
      vector = draw_vector();
    return result;
  }

  std::vector<Element>                 elements;
  Element                              rows;
  Numbers                              diagonal;
  std::vector<Pair>                    axes, sections;
  std::vector<Weighted>                motions;
  std::vector<std::array<Weighted, 2>> loads; /**< of each of these motions */

  /** Sums of all that. */
  Vectors            forces;
  FullMatrix<double> symmetric, unsymmetric;

private:
  /** Between -1 and 1. */
  double
  number()
  {
    return 2. * generator() / generator.max() - 1.;
  }

  Tensor<1, 3>
  draw_vector()
  {
    Tensor<1, 3> vector;
    for (unsigned int d = 0; d < 3; ++d)
      vector[d] = number();
    return vector;
  }

  Numbers
  draw_numbers(const unsigned int n)
  {
    Numbers result(n);
    for (double &x : result)
      x = number();
    return result;
  }

  /** Different ones, in no order. */
  Blocks
  draw_blocks(const unsigned int n)
  {
    Blocks blocks;
    while (blocks.size() < n)
      {
        const unsigned int block = generator() % forces.size();
        if (std::count(blocks.begin(), blocks.end(), block) == 0)
          blocks.push_back(block);
      }
    return blocks;
  }

  Element
  draw_element(const Blocks &blocks)
  {
    const unsigned int n = 3 * blocks.size();
    Element            element{blocks, draw_numbers(n), draw_numbers(n * n)};
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < i; ++j)
        element.tangent[i * n + j] = element.tangent[j * n + i];
    return element;
  }

  Pair
  draw_pair(const unsigned int n)
  {
    Pair pair{draw_blocks(n), draw_numbers(n), {}};
    for (unsigned int d = 0; d < 3; ++d)
      for (unsigned int e = 0; e <= d; ++e)
        pair.stiffness[d][e] = number();
    return pair;
  }

  Weighted
  draw_weighted()
  {
    return {draw_vector(), draw_blocks(2), draw_numbers(2)};
  }

  void
  add(const Element &element)
  {
    const unsigned int n = 3 * element.blocks.size();
    for (unsigned int i = 0; i < n; ++i)
      {
        const unsigned int row = element.blocks[i / 3];
        forces[row][i % 3] += element.residual[i];
        for (unsigned int j = 0; j < n; ++j)
          symmetric(3 * row + i % 3, 3 * element.blocks[j / 3] + j % 3) +=
            element.tangent[i * n + j];
      }
  }

  /** The forces v_i F (G . sum w_j x_j). */
  void
  add_unsymmetric(const Weighted &motion, const Weighted &load)
  {
    for (unsigned int i = 0; i < load.blocks.size(); ++i)
      for (unsigned int j = 0; j < motion.blocks.size(); ++j)
        for (unsigned int d = 0; d < 3; ++d)
          for (unsigned int e = 0; e < 3; ++e)
            unsymmetric(3 * load.blocks[i] + d, 3 * motion.blocks[j] + e) +=
              load.weights[i] * load.vector[d] * motion.weights[j] *
              motion.vector[e];
  }

  std::mt19937 generator{3};
};

#endif
