#include <heddle/base/choice.h>
#include <heddle/base/petsc.h>
#include <heddle/solver/linear_solver.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <string>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /** Iterations for fibers that nothing couples: more are in vain. */
      constexpr PetscInt most_by_themselves = 20;

      /** No tolerance of an iterative solver is looser. */
      constexpr double loosest = 0.9;

      /**
       * Conjugate gradients, which leave the unsymmetric terms out, are good
       * enough if no more of the right-hand side is left. They are as long as
       * little slips, and often not where bundles slide over each other
       * (doc/what_was_tried.md).
       */
      constexpr double good_enough = 0.2;

      /**
       * Far from symmetric is a system of which they leave as much as this. The
       * preconditioner overrates what is left: where the matrix is factorized
       * good_enough is the limit (doc/what_was_tried.md).
       */
      constexpr double no_use = 0.9;

      /**
       * Nearly symmetric is a system of which no more than this is left, or
       * little more than what the tolerance leaves in any case.
       */
      constexpr double hardly_any   = 0.05;
      constexpr double of_tolerance = 1.5;

      /**
       * Tolerance of GMRES, which goes by the motion that the residual makes
       * and not by its energy, over that of conjugate gradients.
       */
      constexpr double stricter = 0.1;

      /** Vectors that GMRES keeps. */
      constexpr unsigned int n_kept = 60;

      /** Its tolerance where the matrix is factorized. */
      constexpr double exact = 1e-10;



      /**
       * What a motion of one makes of the surface of a fiber [mm, or mm per
       * unit], for the components of owned blocks: sections turn about the
       * centerline, and with its nodes, or those of a matrix, it goes along.
       */
      void
      set_levers(const System::State &state, Vec levers)
      {
        const System::FiberSpace &space = state.space;
        petsc(VecSet(levers, 1.));
        double *values;
        petsc(VecGetArray(levers, &values));
        const auto owned = space.owned_fibers();
        for (unsigned int f = owned.first; f < owned.second; ++f)
          for (unsigned int b = 0; b < space.n_blocks(f); ++b)
            if (b % space.n_blocks_per_node() != 0)
              std::fill_n(values + 3 * (state.local_block(f) + b),
                          3,
                          space.fiber(f).radius);
        petsc(VecRestoreArray(levers, &values));
      }



      /**
       * Whether a factorization failed for want of memory. PETSc says so, too,
       * where the pivots of MUMPS do not fit into the room that it had left for
       * them, as happens with tangents that are next to singular.
       */
      bool
      lacks_memory(const PC pc, const PCFailedReason reason)
      {
        if (reason != PC_FACTOR_OUTMEMORY)
          return false;
        Mat factor;
        petsc(PCFactorGetMatrix(pc, &factor));
        PetscInt error;
        petsc(MatMumpsGetInfog(factor, 1, &error));
        return error == -13;
      }



      /** Of all ranks: as many as the matrix has negative eigenvalues. */
      PetscInt
      n_negative_pivots(const PC pc)
      {
        Mat factor;
        petsc(PCFactorGetMatrix(pc, &factor));
        PetscInt number;
        petsc(MatMumpsGetInfog(factor, 12, &number));
        return number;
      }



      /** Set an option of PETSc, unless the user has. */
      void
      set_default(const std::string &option, const std::string &value)
      {
        PetscBool set;
        petsc(PetscOptionsHasName(nullptr, nullptr, option.c_str(), &set));
        if (!set)
          petsc(PetscOptionsSetValue(nullptr, option.c_str(), value.c_str()));
      }
    } // namespace



    LinearSolverParameters::LinearSolverParameters(const std::string &section)
      : ParameterAcceptor(section)
    {
      add_choice(*this,
                 "Kind",
                 kind,
                 "'direct': sparse factorization by MUMPS. 'fiber blocks': "
                 "conjugate gradients preconditioned by a factorization of "
                 "each fiber, a correction of how parts of yarns move and, "
                 "in a matrix, an inverse of the block of each node. "
                 "With friction GMRES follows where these leave too much. "
                 "'automatic': direct for few unknowns [-].");
      add_parameter("Tolerance",
                    tolerance,
                    "Reduction of the residual's energy norm by an iterative "
                    "solver in each Newton iteration; three times as much is "
                    "left where friction is still to come. Inactive for "
                    "'direct' [-].",
                    prm,
                    Patterns::Double(1e-14, loosest));
      add_parameter(
        "Maximum iterations",
        max_iterations,
        "Iterations after which an iterative solver hands over what "
        "it has or, as long as no fibers come near each other, the system is "
        "factorized. Inactive for 'direct' [-].",
        prm,
        Patterns::Integer(1));
      add_parameter("Direct below",
                    direct_below,
                    "Number of unknowns below which 'automatic' chooses "
                    "'direct' for fibers without a matrix, as long as none "
                    "come near each other [-].",
                    prm,
                    Patterns::Integer(0));
      add_parameter("Direct below in a matrix",
                    direct_below_in_matrix,
                    "The same of fibers in a matrix, with its unknowns [-].",
                    prm,
                    Patterns::Integer(0));
      add_parameter("Direct below with contact",
                    direct_below_with_contact,
                    "The same where fibers do, with the unknowns of a matrix. "
                    "Iterations of Newton's method are many then, and need not "
                    "be solved exactly [-].",
                    prm,
                    Patterns::Integer(0));
    }



    LinearSolver::LinearSolver(const LinearSolverParameters &parameters,
                               const System::BlockSystem    &system)
      : parameters(parameters)
      , system(system)
      , symmetric(system, System::BlockSystem::Part::symmetric)
      , whole(system, System::BlockSystem::Part::whole)
    {
    }



    void
    LinearSolver::begin_iterating()
    {
      petsc(KSPCreate(system.state.space.communicator(), &iterating));
      petsc(KSPSetOptionsPrefix(iterating, "cg_"));
      PC pc;
      petsc(KSPGetPC(iterating, &pc));
      petsc(KSPSetType(iterating, KSPCG));
      petsc(KSPSetNormType(iterating, KSP_NORM_NATURAL));
      petsc(KSPSetTolerances(iterating,
                             parameters.tolerance,
                             PETSC_DEFAULT,
                             PETSC_DEFAULT,
                             parameters.max_iterations));
      preconditioner = std::make_unique<BlockPreconditioner>(system.state);
      preconditioner->attach_to(pc);
      petsc(KSPSetFromOptions(iterating));
      petsc(KSPGetTolerances(
        iterating, &tolerance, nullptr, nullptr, &max_iterations));

      petsc(KSPCreate(system.state.space.communicator(), &improving));
      petsc(KSPSetOptionsPrefix(improving, "gmres_"));
      petsc(KSPGetPC(improving, &pc));
      petsc(KSPSetType(improving, KSPGMRES));
      petsc(KSPGMRESSetRestart(improving, n_kept));
      petsc(KSPSetInitialGuessNonzero(improving, PETSC_TRUE));
      petsc(KSPConvergedDefaultSetUIRNorm(improving));
      petsc(KSPSetTolerances(
        improving, tolerance, PETSC_DEFAULT, PETSC_DEFAULT, max_iterations));
      preconditioner->attach_to(pc);
      petsc(KSPSetFromOptions(improving));
      petsc(KSPGetTolerances(
        improving, nullptr, nullptr, nullptr, &max_improving_iterations));

      // It goes by motions, which have to be in one unit.
      Vec levers;
      petsc(VecDuplicate(system.solution(), &levers));
      set_levers(system.state, levers);
      petsc(PCSetDiagonalScale(pc, levers));
      petsc(VecDestroy(&levers));
    }



    LinearSolver::~LinearSolver()
    {
      KSPDestroy(&iterating);
      KSPDestroy(&improving);
      // Ranks release a factorization of MUMPS together: who failed alone would
      // wait for ever, and not get to where it says so.
      if (std::uncaught_exceptions() == 0)
        KSPDestroy(&factorizing);
    }



    LinearResult
    LinearSolver::solve(const LinearTask &task)
    {
      LinearResult result;
      multiply_with(nullptr);
      if (!parameters.direct(system.state.n_dofs(),
                             /*contact=*/!task.exactly,
                             /*matrix=*/system.state.matrix() != nullptr) &&
          (iterate(task, result) || !task.exactly))
        return result;
      factorize(result);
      return result;
    }



    void
    LinearSolver::forget()
    {
      multiply_with(nullptr);
      if (preconditioner)
        preconditioner->forget();
    }



    void
    LinearSolver::multiply_with(const FiberBlocks *bands)
    {
      symmetric.set_bands(bands);
      whole.set_bands(bands);
    }



    bool
    LinearSolver::iterate(const LinearTask &task, LinearResult &result)
    {
      if (!iterating)
        begin_iterating();
      preconditioner->set_up(system, task.yarn_motions, gentle);
      const FiberBlocks *bands = preconditioner->whole_matrix();
      multiply_with(bands);
      const PetscInt most = task.exactly && !system.state.matrix()
                              ? std::min(most_by_themselves, max_iterations)
                              : max_iterations;
      petsc(KSPSetOperators(iterating,
                            bands || system.has_couplings_apart()
                              ? symmetric.matrix()
                              : system.tangent(),
                            system.tangent()));
      const bool converged = run(
        iterating, std::min(task.looser * tolerance, loosest), most, result);
      // That a tangent is not positive definite is not the preconditioner's
      // fault.
      gentle = gentle || !(converged || result.indefinite);
      last   = iterating;
      result.indefinite =
        result.indefinite || (task.exactly && bands && has_unstable_fiber());
      if (!system.has_unsymmetric_terms())
        return converged;
      PC pc;
      petsc(KSPGetPC(iterating, &pc));
      const double left = part_left(pc);
      result.nearly_symmetric =
        left <= std::max(hardly_any, of_tolerance * tolerance);
      if (left <= good_enough)
        return converged;
      result.unsymmetric = left > no_use;
      petsc(KSPSetOperators(improving, whole.matrix(), system.tangent()));
      return run(improving,
                 stricter * tolerance / std::max(good_enough, left),
                 max_improving_iterations,
                 result);
    }



    bool
    LinearSolver::has_unstable_fiber() const
    {
      return !system.has_couplings_apart() &&
             Utilities::MPI::max(preconditioner->has_unstable_fiber() ? 1 : 0,
                                 system.state.space.communicator()) > 0;
    }



    bool
    LinearSolver::run(KSP            solver,
                      const double   tolerance_now,
                      const PetscInt most_iterations,
                      LinearResult  &result)
    {
      petsc(KSPSetTolerances(
        solver, tolerance_now, PETSC_DEFAULT, PETSC_DEFAULT, most_iterations));
      petsc(KSPSolve(solver, system.right_hand_side(), system.solution()));
      KSPConvergedReason reason;
      PetscInt           iterations;
      petsc(KSPGetConvergedReason(solver, &reason));
      petsc(KSPGetIterationNumber(solver, &iterations));
      result.iterations += iterations;
      result.indefinite =
        result.indefinite || reason == KSP_DIVERGED_INDEFINITE_MAT;
      return reason > 0;
    }



    double
    LinearSolver::energy(PC preconditioner, Vec forces) const
    {
      Vec motion;
      petsc(VecDuplicate(forces, &motion));
      double value;
      petsc(PCApply(preconditioner, forces, motion));
      petsc(VecDot(forces, motion, &value));
      petsc(VecDestroy(&motion));
      return value;
    }



    double
    LinearSolver::part_left(PC preconditioner) const
    {
      Vec left;
      petsc(VecDuplicate(system.solution(), &left));
      petsc(MatMult(whole.matrix(), system.solution(), left));
      petsc(VecAYPX(left, -1., system.right_hand_side()));
      const double after  = energy(preconditioner, left),
                   before = energy(preconditioner, system.right_hand_side());
      petsc(VecDestroy(&left));
      return std::sqrt(after / before);
    }



    double
    LinearSolver::energy_of_residual() const
    {
      Vec residual;
      petsc(VecDuplicate(system.solution(), &residual));
      system.get_unbalanced(residual);
      PC pc;
      petsc(KSPGetPC(last, &pc));
      const double value = energy(pc, residual);
      petsc(VecDestroy(&residual));
      return value;
    }



    void
    LinearSolver::factorize(LinearResult &result)
    {
      PC pc;
      if (!factorizing)
        {
          petsc(KSPCreate(system.state.space.communicator(), &factorizing));
          petsc(KSPSetOptionsPrefix(factorizing, "direct_"));
          petsc(KSPGetPC(factorizing, &pc));
          petsc(PCSetType(pc, PCCHOLESKY));
          petsc(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));

          // Pivoting needs more room than the analysis foresees, on many ranks
          // above all: leave 200 percent.
          set_default("-direct_mat_mumps_icntl_14", "200");
          petsc(KSPSetFromOptions(factorizing));
        }
      Assert(!system.has_couplings_apart(),
             ExcMessage("What is factorized has to be in the matrix."));
      const bool unsymmetric = system.has_unsymmetric_terms();
      petsc(KSPSetType(factorizing, unsymmetric ? KSPGMRES : KSPPREONLY));
      petsc(KSPSetTolerances(
        factorizing, exact, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT));
      petsc(KSPSetOperators(factorizing,
                            unsymmetric ? whole.matrix() : system.tangent(),
                            system.tangent()));
      petsc(KSPSetUp(factorizing));
      result.factorizations = 1;

      PCFailedReason reason;
      petsc(KSPGetPC(factorizing, &pc));
      petsc(PCGetFailedReason(pc, &reason));
      const MPI_Comm communicator = system.state.space.communicator();
      if (Utilities::MPI::max(lacks_memory(pc, reason) ? 1 : 0, communicator) >
          0)
        throw std::runtime_error(
          "The memory of this machine does not suffice for a factorization "
          "of " +
          std::to_string(system.state.n_dofs()) +
          " unknowns; set Linear solver/Kind to \"fiber blocks\".");
      result.singular =
        Utilities::MPI::max(reason == PC_NOERROR ? 0 : 1, communicator) > 0;
      if (result.singular)
        // After a zero pivot PETSc's interface to MUMPS takes any further
        // factorization for done: it has to begin with the analysis.
        petsc(PCReset(pc));
      else
        {
          last = factorizing;
          // Stability without an energy is another question.
          result.indefinite = !unsymmetric && n_negative_pivots(pc) > 0;
          if (unsymmetric)
            {
              petsc(PCApply(pc, system.right_hand_side(), system.solution()));
              const double left       = part_left(pc);
              result.unsymmetric      = left > good_enough;
              result.nearly_symmetric = left <= hardly_any;
            }
          petsc(
            KSPSolve(factorizing, system.right_hand_side(), system.solution()));
        }
    }
  } // namespace Solver
} // namespace Heddle
