// The forces of an end moment have exactly this moment, whatever the section
// vectors, and their tangent is their derivative. What is predicted of a step
// misses the truth by the square of the step.
#include <heddle/beam/end_moment.h>

#include "random_element.h"

using State = std::vector<Tensor<1, 3>>;



/** Distance of the tangent from central differences. */
double
error(const State &vectors, const Tensor<1, 3> &moment, const double step)
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
miss(const State &vectors, const Tensor<1, 3> &moment, const double step)
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



int
main()
{
  initlog();
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

      const double coarse = error(vectors, moment, 2e-3);
      const double fine   = error(vectors, moment, 1e-3);
      deallog << n_vectors << " vectors: whole moment "
              << (missing.norm() < 1e-14) << ", order of the tangent "
              << rounded(std::log2(coarse / fine)) << ", small "
              << (fine < 1e-3) << ", order of the prediction "
              << rounded(std::log2(miss(vectors, moment, 2e-3) /
                                   miss(vectors, moment, 1e-3)),
                         1)
              << std::endl;
    }
}
