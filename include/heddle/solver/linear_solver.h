#ifndef heddle_solver_linear_solver_h
#define heddle_solver_linear_solver_h

#include <heddle/solver/block_preconditioner.h>
#include <heddle/solver/tangent_operator.h>
#include <heddle/system/block_system.h>

#include <deal.II/base/parameter_acceptor.h>

#include <petscksp.h>

#include <memory>
#include <string>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    /** How linear systems are solved. */
    enum class LinearSolverKind
    {
      automatic,   /**< direct for few unknowns */
      direct,      /**< sparse factorization */
      fiber_blocks /**< conjugate gradients */
    };

    /** How the user names them. */
    constexpr const char *
    word(const LinearSolverKind kind)
    {
      switch (kind)
        {
          case LinearSolverKind::automatic:
            return "automatic";
          case LinearSolverKind::direct:
            return "direct";
          case LinearSolverKind::fiber_blocks:
            return "fiber blocks";
        }
      return nullptr;
    }



    class LinearSolverParameters : public ParameterAcceptor
    {
    public:
      LinearSolverParameters(const std::string &section = "/Linear solver");

      /**
       * Whether a symmetric system of so many unknowns is factorized, where
       * fibers are in @p contact or not, in a @p matrix or not.
       */
      bool
      direct(const unsigned int n_dofs,
             const bool         contact,
             const bool         matrix) const
      {
        const unsigned int below = contact  ? direct_below_with_contact
                                   : matrix ? direct_below_in_matrix
                                            : direct_below;
        switch (kind)
          {
            case LinearSolverKind::automatic:
              return n_dofs < below;
            case LinearSolverKind::direct:
              return true;
            case LinearSolverKind::fiber_blocks:
              return false;
          }
        Assert(false, ExcInternalError());
        return false;
      }

      LinearSolverKind kind           = LinearSolverKind::automatic;
      double           tolerance      = 0.03;
      unsigned int     max_iterations = 400;
      unsigned int     direct_below   = 15000;

      unsigned int direct_below_in_matrix    = 100000;
      unsigned int direct_below_with_contact = 2500;
    };

    /** How good a solution of a linear system is to be. */
    struct LinearTask
    {
      /**
       * Whether it is factorized where conjugate gradients do not converge,
       * since the tangent is not positive definite or in too many iterations.
       * Otherwise they hand over what they have.
       */
      bool exactly = true;

      /**
       * Whether conjugate gradients are helped to find how yarns and their
       * parts move. If not these move less than they should, as if damped.
       */
      bool yarn_motions = true;

      /** By how much their tolerance is more than the usual one [-]. */
      double looser = 1.;
    };

    /** How the linear system of a Newton iteration was solved. */
    struct LinearResult
    {
      unsigned int iterations       = 0; /**< of an iterative solver */
      unsigned int factorizations   = 0;
      bool         singular         = false; /**< then there is no solution */
      bool         unsymmetric      = false; /**< far from symmetric */
      bool         nearly_symmetric = true;  /**< or symmetric */
      bool         indefinite       = false; /**< as has been found */
    };

    /**
     * Solver of the linear systems of one BlockSystem: a sparse factorization
     * by MUMPS (LDL^T), which needs all that is symmetric in the matrix, or
     * conjugate gradients with BlockPreconditioner. Where the tangent has
     * unsymmetric terms beside its matrix, GMRES goes on from what these have
     * found, if that is not good enough.
     */
    class LinearSolver
    {
    public:
      LinearSolver(const LinearSolverParameters &parameters,
                   const System::BlockSystem    &system);

      ~LinearSolver();

      LinearSolver(const LinearSolver &) = delete;
      LinearSolver &
      operator=(const LinearSolver &) = delete;

      /**
       * Solve for system.solution() what system.tangent(), the terms beside it
       * and system.right_hand_side() ask for.
       * An exact solution is for where no fibers come near each other. Without
       * a matrix, too, the preconditioner is the inverse then, but for shifts
       * and round-off: there conjugate gradients are not given many iterations.
       * @note Collective.
       */
      LinearResult
      solve(const LinearTask &task = LinearTask());

      /** Forget the blocks of the fibers, which each solution takes anew. */
      void
      forget();

      /**
       * Energy of the unbalanced forces of the system as last assembled: what
       * they do [N mm] along the motion that the preconditioner, or the
       * factorization, of the last solution makes of them.
       * @note Collective.
       */
      double
      energy_of_residual() const;

    private:
      void
      begin_iterating();

      /** Let products be those of the last blocks, or of the matrix. */
      void
      multiply_with(const FiberBlocks *bands);

      /** Return whether it converged. */
      bool
      iterate(const LinearTask &task, LinearResult &result);

      /**
       * Whether the tangent, of fibers that nothing couples, is known not to be
       * positive definite: conjugate gradients need not come upon it, as where
       * a straight column has no force across.
       */
      bool
      has_unstable_fiber() const;

      /** Return whether @p solver, as it is set up, converged. */
      bool
      run(KSP            solver,
          const double   tolerance,
          const PetscInt most_iterations,
          LinearResult  &result);

      /** What @p forces do along the motion that @p preconditioner makes of
       * them. */
      double
      energy(PC preconditioner, Vec forces) const;

      /** What the solution leaves of the right-hand side, in the energy norm of
       * @p preconditioner. */
      double
      part_left(PC preconditioner) const;

      void
      factorize(LinearResult &result);

      const LinearSolverParameters &parameters;
      const System::BlockSystem    &system;
      TangentOperator               symmetric, whole;
      KSP                           iterating   = nullptr;
      KSP                           improving   = nullptr;
      KSP                           factorizing = nullptr;
      KSP                           last        = nullptr;
      double                        tolerance   = 0.; /**< usual [-] */
      /** In force, as the tolerance is: of conjugate gradients and of GMRES. */
      PetscInt max_iterations = 0, max_improving_iterations = 0;
      std::unique_ptr<BlockPreconditioner> preconditioner;

      /** With the usual shift of unstable fibers a system was not solved. */
      bool gentle = false;
    };
  } // namespace Solver
} // namespace Heddle

#endif
