#ifndef heddle_solver_fiber_damping_h
#define heddle_solver_fiber_damping_h

#include <heddle/system/contribution.h>

#include <vector>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    /**
     * A stiffness that holds the surface of each fiber back in an iteration,
     * after Levenberg (1944) and Marquardt (1963), but fiber by fiber: a fiber
     * that wants to move far is held the more the farther, one that is at rest
     * is let go. So a few fibers that still travel along soft modes do not keep
     * the others from their equilibrium. It is a part of the tangent only.
     *
     * Every rank keeps the values of its own fibers.
     */
    class FiberDamping
    {
    public:
      /**
       * @p first is the value from which fibers in motion start, in units of
       * E A / R^2 per length; if it is zero none is ever held back.
       */
      FiberDamping(const System::FiberSpace &space, const double first);

      /** Start anew: hold all fibers back, or none yet. */
      void
      reset(const bool in_motion);

      /**
       * Hold all fibers back where nothing touches them. What is the least for
       * fibers in contact is far more than slender ones resist to being bent:
       * theirs is (R / L)^4, and they go by parts of their length.
       */
      void
      reset_alone();

      /** Fibers have come to touch: from now on they are held back as such. */
      void
      end_alone();

      /** Add the stiffness to the blocks that it holds. */
      void
      add_to(System::BlockSystem &system, const System::State &state) const;

      /**
       * Add what resists, at most, motions that nothing resists: the last
       * digits of the stiffness of nodes, E A / h over their distance h, and
       * what forces that are @p unbalanced [N] do as a fiber turns, over its
       * length. That is not in units of the radius: a slender column that
       * buckles is far softer.
       */
      void
      add_uncertainty_to(System::BlockSystem &system,
                         const System::State &state,
                         const double         unbalanced) const;

      /** Local part of @p increment . stiffness . @p increment [N mm]. */
      double
      curvature(const System::State     &state,
                const System::Increment &increment) const;

      /**
       * Learn from the solution @p increment of a linear system, of which the
       * part @p taken was a step. Lengths are in units of @p radius [mm].
       */
      void
      adapt(const System::State     &state,
            const System::Increment &increment,
            const double             taken,
            const double             radius);

      /**
       * The increment led uphill: hold all fibers back more, as far as that
       * goes; return whether it does on any rank.
       * @note Collective.
       */
      bool
      raise();

    private:
      /**
       * Call @p action(block, lever) for the positions, with 1, and section
       * vectors, with @p of_sections, of fiber @p f.
       */
      template <typename Action>
      void
      for_each_block(const System::State &state,
                     const unsigned int   f,
                     const double         of_sections,
                     const Action        &action) const;

      /** Call @p action(block, stiffness) for those of all owned fibers. */
      template <typename Action>
      void
      for_each_stiffness(const System::State &state,
                         const Action        &action) const;

      /** The least damping of fiber @p f, from which it may rise again: it
       * counts as none. */
      double
      least_of(const unsigned int f) const;

      /** The damping of the k-th owned fiber that is in use. */
      double
      used(const unsigned int k) const;

      const System::FiberSpace &space;
      const double              first;
      bool                      alone = false; /**< nothing touches */
      std::vector<double>       values;        /**< of owned fibers [-] */
    };
  } // namespace Solver
} // namespace Heddle

#endif
