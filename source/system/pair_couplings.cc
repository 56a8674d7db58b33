#include <heddle/system/pair_couplings.h>

namespace Heddle
{
  namespace System
  {
    template <unsigned int n_of_side>
    void
    PairCouplings<n_of_side>::clear()
    {
      groups.clear();
      terms.clear();
    }



    template <unsigned int n_of_side>
    void
    PairCouplings<n_of_side>::add_term(const Blocks &blocks, const Term &term)
    {
      if (groups.empty() || groups.back().blocks != blocks)
        groups.push_back({blocks, 0});
      terms.push_back(term);
      groups.back().end = terms.size();
    }



    template <unsigned int n_of_side>
    void
    PairCouplings<n_of_side>::add_product(
      const std::vector<Tensor<1, 3>> &motion,
      std::vector<Tensor<1, 3>>       &forces) const
    {
      // By components, so that those of all blocks are multiplied at once.
      std::array<std::array<Side, 3>, 2> motion_of, force_on;
      for_each_group(
        [&](const Blocks &blocks, const Term *first, const Term *end) {
          for (unsigned int side = 0; side < 2; ++side)
            for (unsigned int d = 0; d < 3; ++d)
              {
                for (unsigned int i = 0; i < n_of_side; ++i)
                  motion_of[side][d][i] =
                    motion[blocks[side * n_of_side + i]][d];
                force_on[side][d].setZero();
              }
          for (const Term *term = first; term < end; ++term)
            for (unsigned int side = 0; side < 2; ++side)
              {
                const Eigen::Map<const Side> here(term->weights.data() +
                                                  side * n_of_side),
                  there(term->weights.data() + (1 - side) * n_of_side);
                Tensor<1, 3> sum;
                for (unsigned int d = 0; d < 3; ++d)
                  sum[d] = here.dot(motion_of[side][d]);
                const Tensor<1, 3> force = term->stiffness * sum;
                for (unsigned int d = 0; d < 3; ++d)
                  force_on[1 - side][d] += force[d] * there;
              }
          for (unsigned int side = 0; side < 2; ++side)
            for (unsigned int i = 0; i < n_of_side; ++i)
              {
                const unsigned int block = blocks[side * n_of_side + i];
                if (block < forces.size())
                  for (unsigned int d = 0; d < 3; ++d)
                    forces[block][d] += force_on[side][d][i];
              }
        });
    }



    template class PairCouplings<4>;
    template class PairCouplings<8>;
  } // namespace System
} // namespace Heddle
