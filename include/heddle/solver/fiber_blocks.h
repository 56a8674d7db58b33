#ifndef heddle_solver_fiber_blocks_h
#define heddle_solver_fiber_blocks_h

#include <heddle/system/block_system.h>

#include <petscpc.h>

#include <vector>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    /**
     * Preconditioner of one banded Cholesky factorization for each fiber. The
     * band holds the elasticity of the fiber and what contact adds to it;
     * coupling to other fibers is left out.
     */
    class FiberBlocks
    {
    public:
      FiberBlocks(const System::State &state);

      /** Take the blocks from @p matrix and factorize them. */
      void
      set_up(Mat matrix);

      /** Let @p pc apply this object. */
      void
      attach_to(PC pc);

    private:
      static PetscErrorCode
      apply(PC pc, Vec residual, Vec result);

      void
      extract(Mat matrix);

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
