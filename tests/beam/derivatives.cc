// Forces and tangents of a fiber are derivatives, by differences of order two,
// those of an end moment too; what is predicted for mixed integration points
// misses the truth by the square of the step.
#include <heddle/beam/end_moment.h>

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



/**
 * The residual is the gradient of the energy and the tangent is the gradient of
 * the residual: central differences approach both with the order two.
 */
void
elements()
{
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



double
distance(const std::vector<double> &a, const std::vector<double> &b)
{
  double sum = 0.;
  for (unsigned int i = 0; i < a.size(); ++i)
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}



std::vector<double>
predict(const RandomElement &random, const State &at, const State &increment)
{
  std::vector<double> stresses(random.element->n_strains());
  random.element->predict_stresses(random.section,
                                   at.data(),
                                   increment.data(),
                                   random.length,
                                   random.reference_strains.data(),
                                   stresses.data());
  return stresses;
}



double
stress_miss(const RandomElement &random,
            const State         &direction,
            const double         step)
{
  State increment = direction, end = random.blocks;
  for (unsigned int b = 0; b < end.size(); ++b)
    {
      increment[b] = step * direction[b];
      end[b] += increment[b];
    }
  return distance(predict(random, random.blocks, increment),
                  predict(random, end, State(end.size())));
}



/**
 * Newton with mixed integration points: with the true stresses as prediction
 * the tangent is the ordinary one; the prediction misses the true stresses
 * after a step by the square of the step; the residual never depends on it.
 */
void
predictions()
{
  for (const Kind &kind : all_elements)
    {
      RandomElement random(kind, /*seed=*/7);
      const State   zero(random.blocks.size());
      State         direction = zero;
      random.disturb(direction, 1.);

      std::vector<double> residual, tangent, mixed_residual, mixed_tangent;
      const auto          stresses = predict(random, random.blocks, zero);
      random.assemble(random.blocks, &residual, &tangent);
      random.assemble(
        random.blocks, &mixed_residual, &mixed_tangent, stresses.data());
      const bool same = distance(tangent, mixed_tangent) < 1e-12;

      const std::vector<double> far(stresses.size(), 1.);
      random.assemble(random.blocks, &mixed_residual, nullptr, far.data());
      deallog << kind.name << ' ' << kind.degree << ": same tangent " << same
              << ", same residual "
              << (distance(residual, mixed_residual) < 1e-15)
              << ", order of the prediction ";
      const double coarse = stress_miss(random, direction, 2e-2);
      if (coarse > 1e-12)
        deallog << rounded(
          std::log2(coarse / stress_miss(random, direction, 1e-2)));
      deallog << std::endl;
    }
}



/** Distance of the tangent from central differences. */
double
tangent_error(const State        &vectors,
              const Tensor<1, 3> &moment,
              const double        step)
{
  const unsigned int  n = 3 * vectors.size();
  std::vector<double> forces(n), tangent(n * n), plus(n), minus(n);
  Heddle::Beam::end_moment(moment,
                           vectors.size(),
                           vectors.data(),
                           nullptr,
                           forces.data(),
                           tangent.data());

  double sum = 0.;
  for (unsigned int j = 0; j < n; ++j)
    {
      State state = vectors;
      state[j / 3][j % 3] += step;
      Heddle::Beam::end_moment(
        moment, vectors.size(), state.data(), nullptr, plus.data(), nullptr);
      state[j / 3][j % 3] -= 2. * step;
      Heddle::Beam::end_moment(
        moment, vectors.size(), state.data(), nullptr, minus.data(), nullptr);
      for (unsigned int i = 0; i < n; ++i)
        sum +=
          std::pow((plus[i] - minus[i]) / (2. * step) - tangent[i * n + j], 2);
    }
  return std::sqrt(sum);
}



/** Distance of the prediction of a step from the truth at its end. */
double
moment_miss(const State &vectors, const Tensor<1, 3> &moment, const double step)
{
  State increment(vectors.size()), end = vectors;
  for (unsigned int a = 0; a < vectors.size(); ++a)
    {
      increment[a] = step * Tensor<1, 3>({.3, -.5 + a, .7});
      end[a] += increment[a];
    }
  const State zero(vectors.size());
  const auto  predict = [&](const State &at, const State &by) {
    return Heddle::Beam::predict_end_moment(
      moment, vectors.size(), at.data(), by.data(), /*predicted=*/nullptr);
  };
  return (predict(vectors, increment) - predict(end, zero)).norm();
}



/**
 * The forces of an end moment have exactly this moment, whatever the section
 * vectors, and their tangent is their derivative. What is predicted of a step
 * misses the truth by the square of the step.
 */
void
end_moments()
{
  const Tensor<1, 3> moment({1., -2., 3.});
  for (const unsigned int n_vectors : {1, 2})
    {
      RandomElement       random({"director", 1}, /*seed=*/9);
      State               vectors(random.blocks.begin() + 1,
                    random.blocks.begin() + 1 + n_vectors);
      std::vector<double> forces(3 * n_vectors);
      Heddle::Beam::end_moment(
        moment, n_vectors, vectors.data(), nullptr, forces.data(), nullptr);

      Tensor<1, 3> missing = moment;
      for (unsigned int a = 0; a < n_vectors; ++a)
        missing -= cross_product_3d(
          vectors[a],
          Tensor<1, 3>({forces[3 * a], forces[3 * a + 1], forces[3 * a + 2]}));
      // A tangent takes all but the component along itself.
      if (n_vectors == 1)
        missing -=
          (moment * vectors[0]) / vectors[0].norm_square() * vectors[0];

      const double coarse = tangent_error(vectors, moment, 2e-3);
      const double fine   = tangent_error(vectors, moment, 1e-3);
      deallog << n_vectors << " vectors: whole moment "
              << (missing.norm() < 1e-14) << ", order of the tangent "
              << rounded(std::log2(coarse / fine)) << ", small "
              << (fine < 1e-3) << ", order of the prediction "
              << rounded(std::log2(moment_miss(vectors, moment, 2e-3) /
                                   moment_miss(vectors, moment, 1e-3)),
                         1)
              << std::endl;
    }
}



int
main()
{
  initlog();
  run_part("Elements", elements);
  run_part("Predicted stresses", predictions);
  run_part("End moment", end_moments);
}
