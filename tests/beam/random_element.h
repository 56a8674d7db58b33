#ifndef heddle_tests_beam_random_element_h
#define heddle_tests_beam_random_element_h

#include <heddle/base/choice.h>
#include <heddle/beam/element.h>

#include "../tests.h"

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

/** Name and degree of an element, for tests that run over all of them. */
struct Kind
{
  std::string  name;
  unsigned int degree;
};



/** All elements that there are. */
inline const std::vector<Kind> all_elements = {{"hermite", 3},
                                               {"director", 1},
                                               {"director", 2},
                                               {"director", 3}};



/** Round to @p digits decimals, so that a reference does not hang on noise. */
inline double
rounded(const double x, const unsigned int digits = 2)
{
  const double scale = std::pow(10., digits);
  return std::round(x * scale) / scale + 0.;
}



/**
 * One element of a bent and stressed fiber, its blocks and its reference drawn
 * at random, and directions in which to disturb it.
 */
class RandomElement
{
public:
  RandomElement(const Kind &kind, const unsigned int seed)
    : element(Heddle::Beam::make_element(
        Heddle::choice<Heddle::Beam::ElementKind>(kind.name),
        kind.degree))
    , generator(seed)
    , blocks(straight())
    , reference_strains(element->n_strains())
  {
    section        = Heddle::Beam::circular_section(/*radius=*/.4,
                                             /*axial_modulus=*/2.,
                                             /*shear_modulus=*/.5,
                                             /*poisson_ratio=*/.3);
    auto reference = blocks;
    disturb(reference, /*size=*/.2);
    disturb(blocks, /*size=*/.3);
    element->strains(reference.data(), length, reference_strains.data());
  }



  /** Blocks of a straight fiber along x, its sections at rest. */
  std::vector<dealii::Tensor<1, 3>>
  straight() const
  {
    std::vector<dealii::Tensor<1, 3>> result;
    for (unsigned int a = 0; a < element->n_nodes(); ++a)
      {
        result.emplace_back();
        result.back()[0] = a * length / (element->n_nodes() - 1.);
        for (unsigned int b = 1; b < element->n_blocks_per_node(); ++b)
          {
            result.emplace_back();
            result.back()[element->n_blocks_per_node() == 2 ? 0 : b] = 1.;
          }
      }
    return result;
  }



  /** Add random numbers between -@p size and @p size. */
  void
  disturb(std::vector<dealii::Tensor<1, 3>> &vectors, const double size)
  {
    for (auto &vector : vectors)
      for (unsigned int c = 0; c < 3; ++c)
        vector[c] += size * (2. * generator() / generator.max() - 1.);
  }



  /** Energy; with @p gradient and @p tangent where they are wanted. */
  double
  assemble(const std::vector<dealii::Tensor<1, 3>> &at,
           std::vector<double>                     *residual,
           std::vector<double>                     *tangent,
           const double *predicted_stresses = nullptr) const
  {
    const unsigned int n = n_unknowns();
    if (residual != nullptr)
      residual->resize(n);
    if (tangent != nullptr)
      tangent->resize(n * n);
    return element->assemble(section,
                             at.data(),
                             length,
                             reference_strains.data(),
                             predicted_stresses,
                             residual != nullptr ? residual->data() : nullptr,
                             tangent != nullptr ? tangent->data() : nullptr);
  }



  unsigned int
  n_unknowns() const
  {
    return 3 * element->n_blocks();
  }



  const double                           length = 1.7;
  std::unique_ptr<Heddle::Beam::Element> element;
  std::minstd_rand                       generator;
  Heddle::Beam::Section                  section;
  std::vector<dealii::Tensor<1, 3>>      blocks;
  std::vector<double>                    reference_strains;
};

#endif
