// A patch of eight distorted cells, each with 8 or 27 nodes, whose nodes follow
// a uniform deformation: everywhere the strain and the stress are exact, no
// node within is out of balance, and the energy is that of a homogeneous block.
// The exact stresses are closed forms for stretches along the axes, then
// turned.
#include <heddle/base/choice.h>

#include "test_cell.h"

#include <map>

/** Nodes of the patch, on a grid of 2 * degree intervals per edge. */
class Patch
{
public:
  Patch(const unsigned int degree)
    : degree(degree)
    , n(2 * degree + 1)
  {
    Random random(3);
    for (unsigned int i = 0; i < n * n * n; ++i)
      {
        const unsigned int x = i % n, y = i / n % n, z = i / (n * n);
        Tensor<1, 3>       node({1. * x, 1. * y, 1. * z});
        node /= n - 1.;
        for (unsigned int c = 0; c < 3; ++c)
          if (is_within(i))
            node[c] += random.number(.15 / n);
        nodes.push_back(node);
      }
  }

  bool
  is_within(const unsigned int i) const
  {
    const auto inside = [this](const unsigned int x) {
      return x > 0 && x < n - 1;
    };
    return inside(i % n) && inside(i / n % n) && inside(i / (n * n));
  }

  /** Numbers of the nodes of a cell in the order of FE_Q. */
  std::vector<unsigned int>
  cell(const unsigned int c) const
  {
    std::vector<unsigned int> result;
    for (const auto &point : cube(degree))
      {
        unsigned int i = 0;
        for (int d = 2; d >= 0; --d)
          i = n * i + degree * (c >> d & 1) + std::lround(degree * point[d]);
        result.push_back(i);
      }
    return result;
  }

  const unsigned int degree;
  const unsigned int n;
  Nodes              nodes;
};



/** Principal Cauchy stress, and energy density, from the principal stretches.
 */
struct Exact
{
  std::array<double, 3> stress;
  double                energy;
};

Exact
exact(const std::string           &law,
      const std::array<double, 3> &stretch,
      const double                 mu,
      const double                 K)
{
  const double          J = stretch[0] * stretch[1] * stretch[2];
  std::array<double, 3> strain;
  Exact                 result{{}, 0.};
  if (law == "neo-hookean")
    {
      const double trace = stretch[0] * stretch[0] + stretch[1] * stretch[1] +
                           stretch[2] * stretch[2];
      for (unsigned int i = 0; i < 3; ++i)
        result.stress[i] =
          mu * std::pow(J, -5. / 3.) * (stretch[i] * stretch[i] - trace / 3.) +
          .5 * K * (J - 1. / J);
      result.energy = .5 * mu * (std::pow(J, -2. / 3.) * trace - 3.) +
                      .25 * K * (J * J - 1. - 2. * std::log(J));
      return result;
    }
  const bool small = law == "linear";
  for (unsigned int i = 0; i < 3; ++i)
    strain[i] = small ? stretch[i] - 1. : .5 * (stretch[i] * stretch[i] - 1.);
  const double trace = strain[0] + strain[1] + strain[2];
  for (unsigned int i = 0; i < 3; ++i)
    {
      const double S   = 2. * mu * strain[i] + (K - 2. / 3. * mu) * trace;
      result.stress[i] = small ? S : S * stretch[i] * stretch[i] / J;
      result.energy += .5 * S * strain[i];
    }
  return result;
}



void
test(const std::string &law, const unsigned int degree, const bool mean)
{
  const double nu       = .45;
  const auto   material = Heddle::Solid::make_material(
    Heddle::choice<Heddle::Solid::MaterialLaw>(law), 2., nu);
  const Exact expected =
    exact(law, {{1.3, .9, .8}}, 1. / (1. + nu), 2. / (3. - 6. * nu));

  // Stretches along rotated axes, then a rotation for laws that allow it.
  const Tensor<2, 3> axes({{.6, .8, 0.}, {-.8, .6, 0.}, {0., 0., 1.}});
  const Tensor<2, 3> other({{1., 0., 0.}, {0., .8, .6}, {0., -.6, .8}});
  Tensor<2, 3>       stretches, stresses;
  const double       lambda[3] = {1.3, .9, .8};
  for (unsigned int i = 0; i < 3; ++i)
    {
      stretches[i][i] = lambda[i];
      stresses[i][i]  = expected.stress[i];
    }
  const Tensor<2, 3> from = axes * other;
  const Tensor<2, 3> turn =
    law == "linear" ? Tensor<2, 3>(unit_symmetric_tensor<3>()) : other * axes;
  const Tensor<2, 3> F = turn * from * stretches * transpose(from);
  const Tensor<2, 3> stress =
    turn * from * stresses * transpose(from) * transpose(turn);

  const Patch         patch(degree);
  std::vector<double> residual(3 * patch.nodes.size(), 0.), part;
  double              energy = 0., stress_error = 0., mises_error = 0.;
  const double        mises =
    std::sqrt(.5 * (std::pow(expected.stress[0] - expected.stress[1], 2) +
                    std::pow(expected.stress[1] - expected.stress[2], 2) +
                    std::pow(expected.stress[2] - expected.stress[0], 2)));
  for (unsigned int c = 0; c < 8; ++c)
    {
      Nodes reference, positions;
      for (const unsigned int i : patch.cell(c))
        {
          reference.push_back(patch.nodes[i]);
          positions.push_back(F * patch.nodes[i]);
        }
      TestCell cell(*material, degree, reference, mean);
      energy += cell.assemble(positions, &part, nullptr);
      unsigned int a = 0;
      for (const unsigned int i : patch.cell(c))
        for (unsigned int d = 0; d < 3; ++d)
          residual[3 * i + d] += part[a++];
      for (const auto &state : cell.evaluate(positions))
        {
          stress_error = std::max(stress_error,
                                  (Tensor<2, 3>(state.stress) - stress).norm());
          mises_error =
            std::max(mises_error, std::abs(state.von_mises - mises));
        }
    }

  double imbalance = 0., largest = 0.;
  for (unsigned int i = 0; i < residual.size(); ++i)
    (patch.is_within(i / 3) ? imbalance : largest) = std::max(
      patch.is_within(i / 3) ? imbalance : largest, std::abs(residual[i]));
  deallog << law << ", degree " << degree << (mean ? ", mean dilatation" : "")
          << ": energy / exact " << rounded(energy / expected.energy, 6)
          << ", stress " << (stress_error < 1e-12) << ", von Mises "
          << rounded(mises, 4) << ' ' << (mises_error < 1e-12)
          << ", balanced within " << (imbalance < 1e-13 && largest > 1e-3)
          << std::endl;
}



int
main()
{
  initlog();
  for (const std::string &law : all_laws)
    for (const unsigned int degree : {1, 2})
      for (const bool mean_dilatation : {false, true})
        test(law, degree, mean_dilatation);
}
