#include <heddle/solver/fiber_blocks.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

extern "C"
{
  /** LAPACK: Cholesky factorization of a positive definite band. */
  void
  dpbtrf_(const char *uplo,
          const int  *n,
          const int  *kd,
          double     *ab,
          const int  *ldab,
          int        *info);

  /** LAPACK: solution with that factorization. */
  void
  dpbtrs_(const char   *uplo,
          const int    *n,
          const int    *kd,
          const int    *nrhs,
          const double *ab,
          const int    *ldab,
          double       *b,
          const int    *ldb,
          int          *info);
}

namespace Heddle
{
  namespace Solver
  {
    FiberBlocks::FiberBlocks(const System::State &state)
      : state(state)
      // An element couples its own blocks; contact couples the positions of
      // four nodes in a row, or the blocks of one interval.
      , bandwidth(3 * std::max(state.space.element().n_blocks(),
                               state.space.n_blocks_per_node() == 2
                                 ? 4u
                                 : 3 * state.space.n_blocks_per_node() + 1) -
                  1)
    {
    }



    void
    FiberBlocks::set_up(const System::LocalBlocks &tangent)
    {
      extract(tangent);
      factors          = bands;
      const auto owned = state.space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        factorize(f);
    }



    void
    FiberBlocks::extract(const System::LocalBlocks &tangent)
    {
      const unsigned int height = bandwidth + 1;
      bands.assign(std::size_t(3) * state.n_owned_fiber_blocks() * height, 0.);
      const auto owned = state.space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          const unsigned int begin = state.local_block(f),
                             end   = begin + state.space.n_blocks(f);
          for (unsigned int row = begin; row < end; ++row)
            tangent.for_each_of_upper_row(
              row, [&](const unsigned int column, const double *values) {
                if (column >= end || 3 * (column - row) + 2 > bandwidth)
                  return;
                for (unsigned int i = 0; i < 3; ++i)
                  for (unsigned int j = 0; j < 3; ++j)
                    if (column > row || j >= i)
                      bands[std::size_t(3 * row + i) * height +
                            3 * (column - row) + j - i] = values[3 * j + i];
              });
        }
    }



    void
    FiberBlocks::factorize(const unsigned int fiber)
    {
      const int n = 3 * state.space.n_blocks(fiber), kd = bandwidth,
                height = bandwidth + 1;
      const std::size_t begin =
        std::size_t(3) * state.local_block(fiber) * height;
      double largest = 0.;
      for (int i = 0; i < n; ++i)
        largest = std::max(largest, std::abs(bands[begin + i * height]));

      // A compressed fiber may be unstable on its own: shift until it is not.
      for (double shift = 0.;; shift = std::max(10. * shift, 1e-8 * largest))
        {
          std::copy_n(bands.begin() + begin,
                      std::size_t(n) * height,
                      factors.begin() + begin);
          for (int i = 0; i < n; ++i)
            factors[begin + i * height] += shift;
          int info;
          dpbtrf_("L", &n, &kd, factors.data() + begin, &height, &info);
          if (info == 0)
            return;
          AssertThrow(shift <= largest && largest > 0.,
                      ExcMessage("The tangent of a fiber is not finite."));
        }
    }



    void
    FiberBlocks::apply(double *values) const
    {
      const int  kd = bandwidth, height = kd + 1, one = 1;
      const auto owned = state.space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          const std::size_t begin = std::size_t(3) * state.local_block(f);
          const int         n     = 3 * state.space.n_blocks(f);
          int               info;
          dpbtrs_("L",
                  &n,
                  &kd,
                  &one,
                  factors.data() + begin * height,
                  &height,
                  values + begin,
                  &n,
                  &info);
        }
    }
  } // namespace Solver
} // namespace Heddle
