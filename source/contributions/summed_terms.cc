#include <heddle/contributions/summed_terms.h>

#include <algorithm>

namespace Heddle
{
  namespace Contributions
  {
    SummedTerms::SummedTerms(System::BlockSystem &system)
      : system(system)
    {
    }



    void
    SummedTerms::begin(const unsigned int n, const unsigned int *new_blocks)
    {
      if (n == blocks.size() &&
          std::equal(blocks.begin(), blocks.end(), new_blocks))
        return;
      end();
      blocks.assign(new_blocks, new_blocks + n);
      residual_sum.assign(3 * n, 0.);
      if (system.wants_tangent())
        tangent_sum.assign(9 * n * n, 0.);
    }



    void
    SummedTerms::end()
    {
      if (!blocks.empty())
        system.add(blocks.size(),
                   blocks.data(),
                   residual_sum.data(),
                   tangent_sum.data());
      blocks.clear();
    }



    template <unsigned int n_of_side>
    void
    add_side_by_side(
      const typename System::PairCouplings<n_of_side>::Blocks &blocks,
      const typename System::PairCouplings<n_of_side>::Term   &term,
      const Tensor<1, 3>                                      &force,
      SummedTerms                                             &of_a,
      SummedTerms                                             &of_b)
    {
      constexpr unsigned int size    = 3 * n_of_side;
      const unsigned int    *of_side = blocks.data();
      const double          *weights = term.weights.data();
      for (SummedTerms *terms : {&of_a, &of_b})
        {
          terms->begin(n_of_side, of_side);
          for (unsigned int i = 0; i < n_of_side; ++i)
            for (unsigned int d = 0; d < 3; ++d)
              terms->residual()[3 * i + d] += weights[i] * force[d];
          if (terms->wants_tangent())
            for (unsigned int d = 0; d < 3; ++d)
              {
                const double stiffness[3] = {term.stiffness[d][0],
                                             term.stiffness[d][1],
                                             term.stiffness[d][2]};
                double       row[size];
                for (unsigned int j = 0; j < n_of_side; ++j)
                  for (unsigned int e = 0; e < 3; ++e)
                    row[3 * j + e] = weights[j] * stiffness[e];
                for (unsigned int i = 0; i < n_of_side; ++i)
                  {
                    double *sum = terms->tangent() + size * (3 * i + d);
                    for (unsigned int k = 0; k < size; ++k)
                      sum[k] += weights[i] * row[k];
                  }
              }
          of_side += n_of_side;
          weights += n_of_side;
        }
    }



    template void
    add_side_by_side<4>(const System::AxisCouplings::Blocks &,
                        const System::AxisCouplings::Term &,
                        const Tensor<1, 3> &,
                        SummedTerms &,
                        SummedTerms &);
    template void
    add_side_by_side<8>(const System::SectionCouplings::Blocks &,
                        const System::SectionCouplings::Term &,
                        const Tensor<1, 3> &,
                        SummedTerms &,
                        SummedTerms &);
  } // namespace Contributions
} // namespace Heddle
