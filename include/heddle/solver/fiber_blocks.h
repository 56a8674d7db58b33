#ifndef heddle_solver_fiber_blocks_h
#define heddle_solver_fiber_blocks_h

#include <heddle/system/local_blocks.h>
#include <heddle/system/state.h>

#include <vector>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    /**
     * One banded Cholesky factorization for each fiber of this rank. The band
     * holds the elasticity of the fiber and what contact and links to a matrix
     * add to it; coupling to other fibers and to the matrix is left out.
     */
    class FiberBlocks
    {
    public:
      FiberBlocks(const System::State &state);

      /** Take the blocks from a tangent and factorize them. */
      void
      set_up(const System::LocalBlocks &tangent);

      /** Solve for the right-hand side @p values of the own fibers. */
      void
      apply(double *values) const;

    private:
      void
      extract(const System::LocalBlocks &tangent);

      void
      factorize(const unsigned int fiber);

      const System::State &state;
      const unsigned int   bandwidth; /**< number of subdiagonals */
      std::vector<double>  bands;     /**< LAPACK's lower band storage */
      std::vector<double>  factors;
    };
  } // namespace Solver
} // namespace Heddle

#endif
