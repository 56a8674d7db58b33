#ifndef heddle_solver_secants_h
#define heddle_solver_secants_h

#include <petscvec.h>

#include <vector>

namespace Heddle
{
  namespace Solver
  {
    /**
     * What the last steps have told of the stiffness, for tangents that leave
     * a part of it out: of each, the motion s of all unknowns and the change y
     * of unbalanced forces along it. The solution of a linear system is
     * corrected so that y asks for s (BFGS, with the tangent as what is known
     * before; J. Nocedal, Math. Comp. 35, 1980).
     *
     * The tangent of contact resists that fibers slide by some f / D where
     * nothing does: without friction Newton's method converges linearly then.
     */
    class Secants
    {
    public:
      Secants() = default;

      ~Secants();

      Secants(const Secants &) = delete;
      Secants &
      operator=(const Secants &) = delete;

      /** Forget all steps. */
      void
      forget();

      /**
       * The right-hand side of a system that is to be solved: forces that are
       * to be balanced. If a step was taken since the last ones, it is learned
       * from, unless they hardly changed along it.
       * @note Collective, as are the next three.
       */
      void
      observe(Vec right_hand_side);

      /** Take from the right-hand side what is known how to balance. */
      void
      reduce(Vec right_hand_side);

      /**
       * Make the @p solution with what reduce() has left that with all of the
       * right-hand side, which is as it was again.
       */
      void
      complete(Vec right_hand_side, Vec solution);

      /** A @p part of the last solution, or of what it was made, is gone. */
      void
      take(const double part, Vec solution);

    private:
      struct Pair
      {
        Vec    motion = nullptr, change = nullptr;
        double work      = 0.; /**< of the change along the motion */
        double projected = 0.; /**< by reduce(), for complete() */
      };

      /** Pairs in use come first, from the oldest to the latest one. */
      std::vector<Pair> pairs;
      unsigned int      n_used     = 0;
      Vec               before     = nullptr; /**< what was observed */
      Vec               solved     = nullptr; /**< what steps are parts of */
      Vec               whole      = nullptr; /**< what was to be reduced */
      bool              known      = false;   /**< whether these two are */
      double            step_taken = 0.;
    };
  } // namespace Solver
} // namespace Heddle

#endif
