#include <heddle/system/pair_couplings.h>

namespace Heddle
{
  namespace System
  {
    namespace
    {
      /** Four sums side by side, which fit into one register. */
      template <unsigned int n>
      double
      dot(const double *a, const double *b)
      {
        double lanes[4] = {};
        for (unsigned int i = 0; i < n; i += 4)
          for (unsigned int lane = 0; lane < 4; ++lane)
            lanes[lane] += a[i + lane] * b[i + lane];
        return (lanes[0] + lanes[2]) + (lanes[1] + lanes[3]);
      }
    } // namespace



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
      for_each_group(
        [&](const Blocks &blocks, const Term *first, const Term *end) {
          // By components, so that those of all blocks are multiplied at once,
          // and in plain arrays: Eigen's take ten times as long in Debug.
          double motion_of[2][3][n_of_side], force_on[2][3][n_of_side];
          for (unsigned int side = 0; side < 2; ++side)
            for (unsigned int i = 0; i < n_of_side; ++i)
              {
                const Tensor<1, 3> &block =
                  motion[blocks[side * n_of_side + i]];
                for (unsigned int d = 0; d < 3; ++d)
                  {
                    motion_of[side][d][i] = block[d];
                    force_on[side][d][i]  = 0.;
                  }
              }
          for (const Term *term = first; term < end; ++term)
            {
              // In the order xx, yy, zz, xy, xz, yz.
              const double *raw     = term->stiffness.begin_raw();
              const double  k[3][3] = {{raw[0], raw[3], raw[4]},
                                       {raw[3], raw[1], raw[5]},
                                       {raw[4], raw[5], raw[2]}};
              for (unsigned int side = 0; side < 2; ++side)
                {
                  const double *here = term->weights.data() + side * n_of_side,
                               *there =
                                 term->weights.data() + (1 - side) * n_of_side;
                  double sum[3];
                  for (unsigned int d = 0; d < 3; ++d)
                    sum[d] = dot<n_of_side>(here, motion_of[side][d]);
                  for (unsigned int d = 0; d < 3; ++d)
                    {
                      const double force =
                        k[d][0] * sum[0] + k[d][1] * sum[1] + k[d][2] * sum[2];
                      for (unsigned int i = 0; i < n_of_side; ++i)
                        force_on[1 - side][d][i] += force * there[i];
                    }
                }
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
