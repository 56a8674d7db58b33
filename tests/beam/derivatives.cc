// The residual is the gradient of the energy and the tangent is the gradient of
// the residual: central differences approach both with the order two.
#include "random_element.h"

using State = std::vector<Tensor<1, 3>>;



State
moved(const State &state, const State &direction, const double step)
{
  State result = state;
  for (unsigned int b = 0; b < state.size(); ++b)
    result[b] += step * direction[b];
  return result;
}



/** Errors of the differences of energy and residual, relative. */
std::pair<double, double>
errors(const RandomElement &random, const State &direction, const double step)
{
  const unsigned int  n = random.n_unknowns();
  std::vector<double> residual, tangent, plus, minus;
  random.assemble(random.blocks, &residual, &tangent);
  const double difference =
    random.assemble(moved(random.blocks, direction, step), &plus, nullptr) -
    random.assemble(moved(random.blocks, direction, -step), &minus, nullptr);

  double slope = 0., error = 0., size = 0.;
  for (unsigned int i = 0; i < n; ++i)
    {
      double row = 0.;
      for (unsigned int j = 0; j < n; ++j)
        row += tangent[i * n + j] * direction[j / 3][j % 3];
      slope += residual[i] * direction[i / 3][i % 3];
      error += std::pow((plus[i] - minus[i]) / (2. * step) - row, 2);
      size += row * row;
    }
  return {std::abs(difference / (2. * step) - slope) / std::abs(slope),
          std::sqrt(error / size)};
}



double
asymmetry(const RandomElement &random)
{
  const unsigned int  n = random.n_unknowns();
  std::vector<double> tangent;
  random.assemble(random.blocks, nullptr, &tangent);
  double largest = 0.;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      largest =
        std::max(largest, std::abs(tangent[i * n + j] - tangent[j * n + i]));
  return largest;
}



int
main()
{
  initlog();
  for (const Kind &kind : all_elements)
    for (unsigned int seed = 1; seed <= 3; ++seed)
      {
        RandomElement random(kind, seed);
        State         direction(random.blocks.size());
        random.disturb(direction, 1.);
        const auto coarse = errors(random, direction, 2e-3);
        const auto fine   = errors(random, direction, 1e-3);
        deallog << kind.name << ' ' << kind.degree << ", state " << seed
                << ": order of the residual "
                << rounded(std::log2(coarse.first / fine.first))
                << ", of the tangent "
                << rounded(std::log2(coarse.second / fine.second)) << ", small "
                << (fine.first < 1e-3 && fine.second < 1e-3) << ", symmetric "
                << (asymmetry(random) < 1e-12) << std::endl;
      }
}
