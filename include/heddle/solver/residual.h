#ifndef heddle_solver_residual_h
#define heddle_solver_residual_h

#include <heddle/solver/line_search.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    /** Judgement of a residual, over all ranks. */
    struct Residual
    {
      double largest_force = 0.; /**< unbalanced nodal force [N] */
      double mean_force    = 0.; /**< root mean square instead [N] */
      double ratio         = 0.; /**< largest over the typical force [-] */
      double mean_ratio    = 0.; /**< mean over the typical force [-] */
      double matrix_ratio  = 0.; /**< ratio, of the nodes of the matrix [-] */
      double pending       = 0.; /**< prescribed motion left [mm] */
    };

    /**
     * Judge what was assembled into @p system. Forces on a node below those of
     * @p negligible [N] count as none.
     * @note Collective, like the functions below.
     */
    Residual
    judge(const System::BlockSystem             &system,
          const Contributions                   &contributions,
          const std::vector<System::Constraint> &constraints,
          const System::NodeStiffness           &negligible);

    /** Largest motion that is prescribed and not yet done [mm]. */
    double
    pending_motion(const std::vector<System::Constraint> &constraints,
                   const MPI_Comm                         communicator);

    /** "fiber 3 of yarn 1 near (0, 1, 0), where it touches fiber 7" */
    std::string
    largest_imbalance(const System::BlockSystem &system,
                      const Contributions       &contributions);
  } // namespace Solver
} // namespace Heddle

#endif
