#ifndef heddle_solver_linear_solver_h
#define heddle_solver_linear_solver_h

#include <heddle/solver/block_preconditioner.h>
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

    class LinearSolverParameters : public ParameterAcceptor
    {
    public:
      LinearSolverParameters(const std::string &section = "/Linear solver");

      /** Whether a symmetric system of so many unknowns is factorized. */
      bool
      direct(const unsigned int n_dofs) const
      {
        return kind == "direct" ||
               (kind == "automatic" && n_dofs < direct_below);
      }

      std::string  kind           = "automatic";
      double       tolerance      = 0.03;
      unsigned int max_iterations = 400;
      unsigned int direct_below   = 15000;
    };

    /** How the linear system of a Newton iteration was solved. */
    struct LinearResult
    {
      unsigned int iterations = 0; /**< 0 for a factorization */
      bool         indefinite = false;
      bool         singular   = false; /**< then there is no solution */
      bool         converged  = true;
    };

    /**
     * Solver of the linear systems of one BlockSystem: a sparse factorization
     * by MUMPS (LDL^T if the system is symmetric, else LU), or conjugate
     * gradients with BlockPreconditioner.
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

      /** Whether solutions are exact to round-off. */
      bool
      is_direct() const
      {
        return direct;
      }

      /** "MUMPS LDL^T" and the like. */
      std::string
      name() const;

      /**
       * Solve system.tangent() * system.solution() = system.right_hand_side().
       * @note Collective.
       */
      LinearResult
      solve();

    private:
      /** Whether there is a factorization, if one is to be made. */
      bool
      set_up_succeeds();

      const LinearSolverParameters        &parameters;
      const System::BlockSystem           &system;
      const bool                           direct;
      KSP                                  ksp = nullptr;
      std::unique_ptr<BlockPreconditioner> preconditioner;
    };
  } // namespace Solver
} // namespace Heddle

#endif
