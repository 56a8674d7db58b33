#ifndef heddle_solver_equations_h
#define heddle_solver_equations_h

#include <heddle/base/timer.h>
#include <heddle/solver/line_search.h>
#include <heddle/solver/residual.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    /**
     * What the contributions of a scene amount to, all together, in the current
     * configuration of a state: constraints, residual and tangent.
     *
     * Members that are not const are collective, and so are judge() and those
     * that give a step.
     */
    class Equations
    {
    public:
      /** Prescribed motion that is below round-off, in radii. */
      static constexpr double reached = 1e-9;

      /**
       * Begin in a configuration from which it is found which forces are no
       * more than round-off. Terms are assembled into @p system, of this state.
       */
      Equations(System::State       &state,
                const Contributions &contributions,
                System::BlockSystem &system,
                SectionTimer        &timer);

      /** Bring all terms and the constraints up to date. */
      void
      update();

      /** The same, and the pattern of the tangent. */
      void
      prepare();

      void
      assemble(const System::BlockSystem::Want want =
                 System::BlockSystem::Want::residual_and_tangent);

      /** Judge what was assembled last. */
      Residual
      judge() const;

      /** Judge the current configuration, where no system is solved. */
      Residual
      judge_without_tangent();

      /** Prescribed motion that is left in the current configuration [mm]. */
      double
      pending_motion();

      /** Whether any term is not smooth enough for Newton's full step. */
      bool
      is_nonsmooth() const;

      /** Whether a configuration that was guessed may be gone on from. */
      bool
      is_credible() const;

      /** How soft nonsmooth terms are, from 1 to 0. */
      void
      set_softness(const double value);

      double
      softness() const
      {
        return softness_of_terms;
      }

      /** Whether forces of nonsmooth terms turn in the tangent, too. */
      void
      set_geometric_stiffness(const bool wanted);

      /** Let terms improve their guesses; whether one did. */
      bool
      adapt();

      /** Why what is in balance is no equilibrium, by the first term that
       * objects, or nothing. */
      std::string
      objection() const;

      /** The part of @p increment that terms allow, perhaps more than 1. */
      double
      largest_step(const System::Increment &increment) const;

      /** The part of @p increment as far as contacts are known along it. */
      double
      searched_step(const System::Increment &increment) const;

      System::State       &state;
      const Contributions &contributions;
      const NonsmoothTerms nonsmooth;
      System::BlockSystem &system;
      const MPI_Comm       communicator;

      /** The smallest radius of a fiber [mm]. */
      const double length_scale;

    private:
      void
      collect_constraints();

      SectionTimer                   &timer;
      std::vector<System::Constraint> constraints;
      double                          softness_of_terms = 0.;

      /** Forces on nodes below these are last digits [N]. */
      const System::NodeStiffness negligible;
    };
  } // namespace Solver
} // namespace Heddle

#endif
