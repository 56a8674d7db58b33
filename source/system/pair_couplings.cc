#include <heddle/base/lanes.h>
#include <heddle/system/pair_couplings.h>

#include <deal.II/base/exceptions.h>

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
    PairCouplings<n_of_side>::reserve(const std::size_t n_terms)
    {
      Assert(terms.empty(), ExcMessage("Terms were added before."));
      if (terms.capacity() >= n_terms)
        return;

      // The room that there was is not needed beside the new one.
      terms = std::vector<Term>();
      terms.reserve(n_terms);
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
      for_each_group(
        [&](const Blocks &blocks, const Term *first, const Term *end) {
          Lanes<4> motion_of[2][n_of_side], force_on[2][n_of_side];
          for (unsigned int side = 0; side < 2; ++side)
            for (unsigned int i = 0; i < n_of_side; ++i)
              {
                const Tensor<1, 3> &block =
                  motion[blocks[side * n_of_side + i]];
                motion_of[side][i] = Lanes<4>{block[0], block[1], block[2], 0.};
                force_on[side][i]  = Lanes<4>{};
              }
          for (const Term *term = first; term < end; ++term)
            {
              // In the order xx, yy, zz, xy, xz, yz.
              const double  *raw = term->stiffness.begin_raw();
              const Lanes<4> k[] = {{raw[0], raw[3], raw[4], 0.},
                                    {raw[3], raw[1], raw[5], 0.},
                                    {raw[4], raw[5], raw[2], 0.}};
              for (unsigned int side = 0; side < 2; ++side)
                {
                  const double *here = term->weights.data() + side * n_of_side,
                               *there =
                                 term->weights.data() + (1 - side) * n_of_side;

                  // Two sums do not wait for each other.
                  Lanes<4> even = {}, odd = {};
                  for (unsigned int i = 0; i < n_of_side; i += 2)
                    {
                      even += here[i] * motion_of[side][i];
                      odd += here[i + 1] * motion_of[side][i + 1];
                    }
                  const Lanes<4> sum = even + odd;
                  const Lanes<4> force =
                    k[0] * sum[0] + k[1] * sum[1] + k[2] * sum[2];
                  for (unsigned int i = 0; i < n_of_side; ++i)
                    force_on[1 - side][i] += there[i] * force;
                }
            }
          for (unsigned int side = 0; side < 2; ++side)
            for (unsigned int i = 0; i < n_of_side; ++i)
              {
                const unsigned int block = blocks[side * n_of_side + i];
                if (block < forces.size())
                  for (unsigned int d = 0; d < 3; ++d)
                    forces[block][d] += force_on[side][i][d];
              }
        });
    }



    template class PairCouplings<4>;
    template class PairCouplings<8>;
  } // namespace System
} // namespace Heddle
