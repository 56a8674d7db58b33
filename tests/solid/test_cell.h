#ifndef heddle_tests_solid_test_cell_h
#define heddle_tests_solid_test_cell_h

#include <heddle/solid/cell_kernel.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

#include "../tests.h"

#include <cmath>
#include <random>
#include <string>
#include <vector>

/** All laws that there are. */
inline const std::vector<std::string> all_laws = {"linear",
                                                  "st venant-kirchhoff",
                                                  "neo-hookean"};

using Nodes = std::vector<Tensor<1, 3>>;



/** Round to @p digits decimals, so that a reference does not hang on noise. */
inline double
rounded(const double x, const unsigned int digits = 2)
{
  const double scale = std::pow(10., digits);
  return std::round(x * scale) / scale + 0.;
}



/** Nodes of the unit cube in the order of FE_Q. */
inline Nodes
cube(const unsigned int degree)
{
  const FE_Q<3> element(degree);
  return {element.get_unit_support_points().begin(),
          element.get_unit_support_points().end()};
}



/** Random numbers that are the same on all machines. */
class Random
{
public:
  Random(const unsigned int seed)
    : generator(seed)
  {
  }

  /** A number between -@p size and @p size. */
  double
  number(const double size)
  {
    return size * (2. * generator() / generator.max() - 1.);
  }

  /** Move all nodes by at most @p size in each direction. */
  void
  disturb(Nodes &nodes, const double size)
  {
    for (auto &node : nodes)
      for (unsigned int i = 0; i < 3; ++i)
        node[i] += number(size);
  }

  /** A tensor of such numbers. */
  Tensor<2, 3>
  tensor(const double size)
  {
    Tensor<2, 3> result;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        result[i][j] = number(size);
    return result;
  }

private:
  std::minstd_rand generator;
};



/** An isoparametric cell with its reference @p nodes, and a kernel for it. */
class TestCell
{
public:
  TestCell(const Heddle::Solid::Material &material,
           const unsigned int             degree,
           const Nodes                   &nodes,
           const bool                     mean_dilatation)
    : n_points((degree + 1) * (degree + 1) * (degree + 1))
    , nodes(nodes)
    , kernel(material, nodes.size(), n_points, mean_dilatation)
  {
    const FE_Q<3>   element(degree);
    const QGauss<3> quadrature(degree + 1);
    for (unsigned int q = 0; q < n_points; ++q)
      {
        Tensor<2, 3> jacobian;
        for (unsigned int a = 0; a < nodes.size(); ++a)
          jacobian +=
            outer_product(nodes[a], element.shape_grad(a, quadrature.point(q)));
        const Tensor<2, 3> inverse = transpose(invert(jacobian));
        weights.push_back(determinant(jacobian) * quadrature.weight(q));
        for (unsigned int a = 0; a < nodes.size(); ++a)
          {
            const Tensor<1, 3> gradient =
              inverse * element.shape_grad(a, quadrature.point(q));
            for (unsigned int i = 0; i < 3; ++i)
              gradients.push_back(gradient[i]);
          }
      }
  }



  unsigned int
  n_unknowns() const
  {
    return 3 * nodes.size();
  }



  /** Energy; with residual and tangent where they are wanted. */
  double
  assemble(const Nodes         &positions,
           std::vector<double> *residual,
           std::vector<double> *tangent)
  {
    if (residual != nullptr)
      residual->resize(n_unknowns());
    if (tangent != nullptr)
      tangent->resize(n_unknowns() * n_unknowns());
    return kernel.assemble(gradients.data(),
                           weights.data(),
                           positions.data(),
                           residual != nullptr ? residual->data() : nullptr,
                           tangent != nullptr ? tangent->data() : nullptr);
  }



  std::vector<Heddle::Solid::PointState>
  evaluate(const Nodes &positions)
  {
    std::vector<Heddle::Solid::PointState> states(n_points);
    kernel.evaluate(
      gradients.data(), weights.data(), positions.data(), states.data());
    return states;
  }



  const unsigned int        n_points;
  const Nodes               nodes;
  std::vector<double>       gradients;
  std::vector<double>       weights;
  Heddle::Solid::CellKernel kernel;
};

#endif
