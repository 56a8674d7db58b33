// Newton with mixed integration points: with the true stresses as prediction
// the tangent is the ordinary one; the prediction misses the true stresses
// after a step by the square of the step; the residual never depends on it.
#include "random_element.h"

using State = std::vector<Tensor<1, 3>>;



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
miss(const RandomElement &random, const State &direction, const double step)
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



int
main()
{
  initlog();
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
      const double coarse = miss(random, direction, 2e-2);
      if (coarse > 1e-12)
        deallog << rounded(std::log2(coarse / miss(random, direction, 1e-2)));
      deallog << std::endl;
    }
}
