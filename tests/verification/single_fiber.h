#ifndef heddle_tests_verification_single_fiber_h
#define heddle_tests_verification_single_fiber_h

#include <heddle/base/choice.h>
#include <heddle/beam/element.h>
#include <heddle/beam/end_moment.h>

#include "../tests.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

/** Name and degree of an element. */
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



/** Those that know torsion. */
inline const std::vector<Kind> director_elements = {{"director", 1},
                                                    {"director", 2},
                                                    {"director", 3}};



/** Round to @p digits significant digits, for a reference without noise. */
inline double
significant(const double x, const int digits = 2)
{
  if (x == 0.)
    return 0.;
  const double scale =
    std::pow(10., digits - 1 - std::floor(std::log10(std::abs(x))));
  return std::round(x * scale) / scale;
}



/** An error in units of 1e-6: two digits, and none of the iteration's noise. */
inline double
micro(const double error)
{
  return significant(std::round(1e7 * error) / 10.);
}



/** The observed order between two errors, one of half the element length. */
inline double
order(const double coarse, const double fine)
{
  return std::round(10. * std::log2(coarse / fine)) / 10.;
}



/** The word that the reader of a reference looks for. */
inline std::string
verdict(const bool good)
{
  return good ? "" : " FAIL";
}



/** Reference line of a fiber at arc length s, with orthonormal vectors. */
struct Frame
{
  Tensor<1, 3> position;
  Tensor<1, 3> tangent;
  Tensor<1, 3> first;
  Tensor<1, 3> second;
};

using Curve = std::function<Frame(const double s)>;



/** A straight fiber along x, bending towards y with its first vector. */
inline Frame
straight_line(const double s)
{
  return {Tensor<1, 3>({s, 0., 0.}),
          Tensor<1, 3>({1., 0., 0.}),
          Tensor<1, 3>({0., 1., 0.}),
          Tensor<1, 3>({0., 0., 1.})};
}



/** A square matrix with a band, and its solution without exchange of rows. */
class BandMatrix
{
public:
  BandMatrix(const unsigned int size, const unsigned int half_width)
    : size(size)
    , half_width(half_width)
    , entries(size * (2 * half_width + 1), 0.)
  {
  }

  double &
  operator()(const unsigned int i, const unsigned int j)
  {
    return entries[i * (2 * half_width + 1) + half_width + j - i];
  }

  /** Make @p i a row and column of the unit matrix. */
  void
  fix(const unsigned int i)
  {
    for (unsigned int j = i - std::min(i, half_width); j < end(i); ++j)
      (*this)(i, j) = (*this)(j, i) = 0.;
    (*this)(i, i) = 1.;
  }

  /** Replace @p x by the solution; the matrix is used up. */
  void
  solve(std::vector<double> &x)
  {
    for (unsigned int k = 0; k < size; ++k)
      for (unsigned int i = k + 1; i < end(k); ++i)
        {
          const double factor = (*this)(i, k) / (*this)(k, k);
          for (unsigned int j = k + 1; j < end(k); ++j)
            (*this)(i, j) -= factor * (*this)(k, j);
          x[i] -= factor * x[k];
        }
    for (unsigned int k = size; k-- > 0;)
      {
        for (unsigned int j = k + 1; j < end(k); ++j)
          x[k] -= (*this)(k, j) * x[j];
        x[k] /= (*this)(k, k);
      }
  }

private:
  unsigned int
  end(const unsigned int i) const
  {
    return std::min(size, i + half_width + 1);
  }

  unsigned int        size;
  unsigned int        half_width;
  std::vector<double> entries;
};



/**
 * One fiber, clamped at its first node, with a force and a moment of fixed
 * direction at its last, and a Newton iteration of its own.
 */
class SingleFiber
{
public:
  enum class Newton
  {
    standard,
    mixed_points
  };

  SingleFiber(const Kind                  &kind,
              const Heddle::Beam::Section &section,
              const Curve                 &curve,
              const double                 length,
              const unsigned int           n_elements)
    : element(Heddle::Beam::make_element(
        Heddle::choice<Heddle::Beam::ElementKind>(kind.name),
        kind.degree))
    , section(section)
    , length(length)
    , n_elements(n_elements)
    , per_node(element->n_blocks_per_node())
    , stride(per_node * (element->n_nodes() - 1))
  {
    const unsigned int n_nodes = n_elements * (element->n_nodes() - 1) + 1;
    for (unsigned int i = 0; i < n_nodes; ++i)
      {
        const Frame frame = curve(i * length / (n_nodes - 1.));
        blocks.push_back(frame.position);
        if (per_node == 3)
          blocks.insert(blocks.end(), {frame.first, frame.second});
        else
          blocks.push_back(frame.tangent);
      }
    reference_strains.resize(n_elements * element->n_strains());
    predicted_stresses.resize(reference_strains.size());
    for (unsigned int e = 0; e < n_elements; ++e)
      element->strains(&blocks[e * stride],
                       element_length(),
                       &reference_strains[e * element->n_strains()]);
    fixed.resize(3 * blocks.size(), false);
    std::fill_n(fixed.begin(), 3 * per_node, true);
  }

  /**
   * Clamp the first section but let it stretch along its own vectors, for
   * which a fiber that starts along x needs its first vectors along y and z.
   */
  void
  release_stretch()
  {
    if (per_node == 2)
      fixed[3] = false;
    else
      fixed[3 + 1] = fixed[6 + 2] = false;
  }

  /**
   * Find equilibrium from the configuration as it is, and return the number of
   * linear systems that were solved, to an increment of 1e-8 of the length, or
   * n_allowed + 1 without equilibrium.
   */
  unsigned int
  solve(const Tensor<1, 3> &force,
        const Tensor<1, 3> &moment    = Tensor<1, 3>(),
        const Newton        newton    = Newton::mixed_points,
        const unsigned int  n_allowed = 60)
  {
    for (unsigned int iteration = 1; iteration <= n_allowed; ++iteration)
      {
        const bool predicted = newton == Newton::mixed_points && iteration > 1;
        const auto increment = solve_once(force, moment, predicted);
        predict(increment, moment, predicted);
        double largest = 0.;
        for (unsigned int b = 0; b < blocks.size(); ++b)
          {
            blocks[b] += increment[b];
            largest = std::max(
              largest, increment[b].norm() / (b % per_node == 0 ? length : 1.));
          }
        if (!(largest < 1e6))
          return n_allowed + 1;
        if (largest < 1e-8)
          return iteration;
      }
    return n_allowed + 1;
  }

  double
  energy() const
  {
    double sum = 0.;
    for (unsigned int e = 0; e < n_elements; ++e)
      sum += element->assemble(section,
                               &blocks[e * stride],
                               element_length(),
                               &reference_strains[e * element->n_strains()],
                               /*predicted_stresses=*/nullptr,
                               /*residual=*/nullptr,
                               /*tangent=*/nullptr);
    return sum;
  }

  Tensor<1, 3>
  tip() const
  {
    return blocks[blocks.size() - per_node];
  }

  /** Angle of the last section in the plane of x and y. */
  double
  tip_angle() const
  {
    const Tensor<1, 3> *last = &blocks[blocks.size() - per_node];
    const Tensor<1, 3>  normal =
      per_node == 2 ? last[1] : cross_product_3d(last[1], last[2]);
    return std::atan2(normal[1], normal[0]);
  }

  unsigned int
  n_unknowns() const
  {
    return 3 * blocks.size();
  }

private:
  double
  element_length() const
  {
    return length / n_elements;
  }

  std::vector<Tensor<1, 3>>
  solve_once(const Tensor<1, 3> &force,
             const Tensor<1, 3> &moment,
             const bool          predicted) const
  {
    BandMatrix          matrix(n_unknowns(), 3 * element->n_blocks() - 1);
    std::vector<double> rhs(n_unknowns(), 0.);
    add_elements(predicted, matrix, rhs);
    add_loads(force, moment, predicted, matrix, rhs);
    for (unsigned int i = 0; i < n_unknowns(); ++i)
      if (fixed[i])
        {
          matrix.fix(i);
          rhs[i] = 0.;
        }
    matrix.solve(rhs);

    std::vector<Tensor<1, 3>> increment(blocks.size());
    for (unsigned int i = 0; i < n_unknowns(); ++i)
      increment[i / 3][i % 3] = rhs[i];
    return increment;
  }

  void
  add_elements(const bool           predicted,
               BandMatrix          &matrix,
               std::vector<double> &rhs) const
  {
    const unsigned int  n = 3 * element->n_blocks();
    std::vector<double> residual(n), tangent(n * n);
    for (unsigned int e = 0; e < n_elements; ++e)
      {
        const unsigned int first = 3 * e * stride;
        const unsigned int point = e * element->n_strains();
        element->assemble(section,
                          &blocks[e * stride],
                          element_length(),
                          &reference_strains[point],
                          predicted ? &predicted_stresses[point] : nullptr,
                          residual.data(),
                          tangent.data());
        for (unsigned int i = 0; i < n; ++i)
          {
            rhs[first + i] -= residual[i];
            for (unsigned int j = 0; j < n; ++j)
              matrix(first + i, first + j) += tangent[i * n + j];
          }
      }
  }

  void
  add_loads(const Tensor<1, 3>  &force,
            const Tensor<1, 3>  &moment,
            const bool           predicted,
            BandMatrix          &matrix,
            std::vector<double> &rhs) const
  {
    const unsigned int last = n_unknowns() - 3 * per_node;
    for (unsigned int c = 0; c < 3; ++c)
      rhs[last + c] += force[c];

    const unsigned int  n = 3 * (per_node - 1);
    std::vector<double> forces(n), tangent(n * n);
    Heddle::Beam::end_moment(moment,
                             per_node - 1,
                             &blocks[blocks.size() - per_node + 1],
                             predicted ? &predicted_moment : nullptr,
                             forces.data(),
                             tangent.data());
    for (unsigned int i = 0; i < n; ++i)
      {
        rhs[last + 3 + i] += forces[i];
        for (unsigned int j = 0; j < n; ++j)
          matrix(last + 3 + i, last + 3 + j) -= tangent[i * n + j];
      }
  }

  void
  predict(const std::vector<Tensor<1, 3>> &increment,
          const Tensor<1, 3>              &moment,
          const bool                       predicted)
  {
    const unsigned int last = blocks.size() - per_node + 1;
    predicted_moment =
      Heddle::Beam::predict_end_moment(moment,
                                       per_node - 1,
                                       &blocks[last],
                                       &increment[last],
                                       predicted ? &predicted_moment : nullptr);

    for (unsigned int e = 0; e < n_elements; ++e)
      {
        const unsigned int point = e * element->n_strains();
        element->predict_stresses(section,
                                  &blocks[e * stride],
                                  &increment[e * stride],
                                  element_length(),
                                  &reference_strains[point],
                                  &predicted_stresses[point]);
      }
  }

  std::unique_ptr<Heddle::Beam::Element> element;
  Heddle::Beam::Section                  section;
  double                                 length;
  unsigned int                           n_elements;
  unsigned int                           per_node;
  unsigned int                           stride;
  std::vector<double>                    reference_strains;
  std::vector<double>                    predicted_stresses;
  Tensor<1, 3>                           predicted_moment;
  std::vector<bool>                      fixed;

public:
  /** The configuration: the blocks of all nodes, the clamped one first. */
  std::vector<Tensor<1, 3>> blocks;
};

#endif
