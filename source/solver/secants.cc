#include <heddle/base/petsc.h>
#include <heddle/solver/secants.h>

#include <algorithm>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /** Steps that are kept. */
      constexpr unsigned int n_steps_kept = 8;

      /**
       * Forces that change by less than this part of what they were promise
       * no stiffness: the step went along an energy that does not bend.
       */
      constexpr double least_change = 0.01;
    } // namespace



    Secants::~Secants()
    {
      for (Pair &pair : pairs)
        {
          VecDestroy(&pair.motion);
          VecDestroy(&pair.change);
        }
      VecDestroy(&before);
      VecDestroy(&solved);
      VecDestroy(&whole);
    }



    void
    Secants::forget()
    {
      n_used     = 0;
      known      = false;
      step_taken = 0.;
    }



    void
    Secants::observe(Vec right_hand_side)
    {
      if (!before)
        {
          petsc(VecDuplicate(right_hand_side, &before));
          petsc(VecDuplicate(right_hand_side, &solved));
          petsc(VecDuplicate(right_hand_side, &whole));
        }
      if (known && step_taken > 0.)
        {
          if (pairs.size() < n_steps_kept)
            {
              pairs.emplace_back();
              petsc(VecDuplicate(right_hand_side, &pairs.back().motion));
              petsc(VecDuplicate(right_hand_side, &pairs.back().change));
              std::rotate(pairs.begin() + n_used, pairs.end() - 1, pairs.end());
            }
          else if (n_used == n_steps_kept)
            {
              std::rotate(pairs.begin(), pairs.begin() + 1, pairs.end());
              --n_used;
            }
          Pair &latest = pairs[n_used];
          petsc(VecCopy(solved, latest.motion));
          petsc(VecScale(latest.motion, step_taken));
          petsc(VecWAXPY(latest.change, -1., right_hand_side, before));
          double promised;
          petsc(VecDot(latest.motion, before, &promised));
          petsc(VecDot(latest.motion, latest.change, &latest.work));
          if (latest.work > least_change * promised && latest.work > 0.)
            ++n_used;
        }
      petsc(VecCopy(right_hand_side, before));
      known      = false;
      step_taken = 0.;
    }



    void
    Secants::reduce(Vec right_hand_side)
    {
      petsc(VecCopy(right_hand_side, whole));
      for (unsigned int i = n_used; i-- > 0;)
        {
          Pair  &pair = pairs[i];
          double work;
          petsc(VecDot(pair.motion, right_hand_side, &work));
          pair.projected = work / pair.work;
          petsc(VecAXPY(right_hand_side, -pair.projected, pair.change));
        }
    }



    void
    Secants::complete(Vec right_hand_side, Vec solution)
    {
      petsc(VecCopy(whole, right_hand_side));
      for (unsigned int i = 0; i < n_used; ++i)
        {
          double work;
          petsc(VecDot(pairs[i].change, solution, &work));
          petsc(VecAXPY(solution,
                        pairs[i].projected - work / pairs[i].work,
                        pairs[i].motion));
        }
      known = true;
    }



    void
    Secants::take(const double part, Vec solution)
    {
      step_taken = part;
      if (known)
        petsc(VecCopy(solution, solved));
    }
  } // namespace Solver
} // namespace Heddle
