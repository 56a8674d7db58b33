#include <heddle/base/exceptions.h>
#include <heddle/solver/motion_in_parts.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /** A guess that misses more than this of what is prescribed is none. */
      constexpr double largest_miss = 0.5;

      /** A guess of which no more than this may be gone along at a time leads
       * where nothing can go. */
      constexpr double least_part_of_guess = 1e-3;

      /** Parts of a step below this are round-off. */
      constexpr double round_off = 1e-13;

      /** Searches of contacts along one step where there is none. */
      constexpr unsigned int most_parts_of_step = 100;



      /** The motion of owned blocks, and of the ghosts that there are now. */
      System::Increment
      with_ghosts(const System::State &state, const System::Increment &motion)
      {
        System::Increment whole = motion;
        whole.resize(state.n_local_blocks());
        state.update_ghosts(whole);
        return whole;
      }
    } // namespace



    bool
    follow(Equations               &equations,
           const System::Increment &guess,
           StopRequest             &stop)
    {
      // A rank without fibers has no part in a guess, but goes along. Without
      // nonsmooth terms Newton's method goes further in one step.
      if (Utilities::MPI::max(guess.empty() ? 0 : 1, equations.communicator) ==
            0 ||
          !equations.is_nonsmooth())
        return false;

      // What does not bring the ends where they are to go leads elsewhere.
      System::State    &state  = equations.state;
      const double      before = equations.pending_motion();
      System::Increment whole  = with_ghosts(state, guess);
      state.move(1., whole);
      const double after = equations.pending_motion();
      state.move(-1., whole);
      if (after >
          largest_miss * before + Equations::reached * equations.length_scale)
        return false;

      double left = 1., part = 0.;
      while (true)
        {
          if (stop.received())
            throw Stopped("stopped by " + stop.reason());
          equations.update();
          whole = with_ghosts(state, guess);
          if (!equations.is_credible())
            {
              state.move(-part, whole);
              return left + part < 1.;
            }
          if (left == 0.)
            return true;
          part = std::min({left,
                           equations.largest_step(whole),
                           equations.searched_step(whole)});
          // The closer to a cell that is inside out, the shorter.
          if (part < std::min(left, least_part_of_guess))
            {
              state.move(left - 1., whole);
              return false;
            }
          state.move(part, whole);
          left = left - part > round_off ? left - part : 0.;
        }
    }



    double
    walk(Equations &equations, System::Increment &increment)
    {
      System::State &state = equations.state;
      const double   whole = std::min(1., equations.largest_step(increment));
      double         taken = 0.;
      for (unsigned int i = 0; i < most_parts_of_step; ++i)
        {
          const double part =
            std::min(whole - taken, equations.searched_step(increment));
          state.move(part, increment);
          taken += part;
          if (taken >= whole)
            break;
          equations.update();
          increment = with_ghosts(state, increment);
          if (equations.is_nonsmooth())
            break;
        }
      state.move(-taken, increment);
      return taken;
    }
  } // namespace Solver
} // namespace Heddle
