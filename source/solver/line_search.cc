#include <heddle/base/petsc.h>
#include <heddle/base/reduce.h>
#include <heddle/solver/line_search.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /** A search ends where the slope is this part of the first one. */
      constexpr double flat = 0.1;

      /** A step is doubled while the slope at its end is steeper than this. */
      constexpr double steep = 0.3;

      /** Places that are tried before the best so far has to do. */
      constexpr unsigned int max_trials = 6;
    } // namespace



    LineSearch::LineSearch(System::State             &state,
                           const Contributions       &contributions,
                           const System::BlockSystem &system,
                           const System::Increment   &increment,
                           const double               damping)
      : state(state)
      , contributions(contributions)
      , increment(increment)
      , start(state.current())
    {
      first_slope = slope(system, increment);

      Vec image;
      petsc(VecDuplicate(system.solution(), &image));
      petsc(MatMult(system.tangent(), system.solution(), image));
      double curvature;
      petsc(VecDot(system.solution(), image, &curvature));
      petsc(VecDestroy(&image));

      const std::array<double, 2> rough = rough_part();
      smooth_slope                      = first_slope - rough[0];
      smooth_curvature                  = curvature - damping - rough[1];
    }



    double
    LineSearch::slope(const System::BlockSystem &system,
                      const System::Increment   &increment)
    {
      std::vector<Tensor<1, 3>> unbalanced;
      system.unbalanced(unbalanced);
      double sum = 0.;
      for (unsigned int b = 0; b < unbalanced.size(); ++b)
        sum += unbalanced[b] * increment[b];
      return Utilities::MPI::sum(sum, system.state.space.communicator());
    }



    double
    LineSearch::best_step(const double longest)
    {
      // Where the slope is still negative the energy still falls; a small
      // positive one is as good. A model that bends down tells nothing of what
      // lies further.
      double low = 0., slope_low = first_slope;
      double high       = std::min(1., longest);
      double slope_high = slope_at(high);
      while (smooth_curvature > 0. &&
             slope_high < -steep * std::abs(first_slope) &&
             2. * high <= longest)
        {
          const double slope_next = slope_at(2. * high);
          if (slope_next > flat * std::abs(first_slope))
            break;
          high *= 2.;
          slope_high = slope_next;
        }

      // Else go to the root of the slope.
      for (unsigned int trial = 0;
           trial < max_trials && slope_high > flat * std::abs(first_slope);
           ++trial)
        {
          const double guess =
            low + (high - low) * slope_low / (slope_low - slope_high);
          const double next = std::clamp(
            guess, low + 0.1 * (high - low), low + 0.7 * (high - low));
          const double slope_next = slope_at(next);
          if (slope_next < -flat * std::abs(first_slope))
            {
              low       = next;
              slope_low = slope_next;
              if (trial + 1 == max_trials)
                return low;
            }
          else
            {
              high       = next;
              slope_high = slope_next;
            }
        }
      return high;
    }



    std::array<double, 2>
    LineSearch::rough_part() const
    {
      std::array<double, 2> sum = {};
      for (const auto &contribution : contributions)
        if (contribution->is_rough())
          {
            const auto part =
              contribution->slope_and_curvature(state, increment);
            sum[0] += part.first;
            sum[1] += part.second;
          }
      sum_over_ranks(sum, state.space.communicator());
      return sum;
    }



    double
    LineSearch::slope_at(const double factor)
    {
      // As the iteration will move, to the last digit: where it ends here
      // nothing has to be found anew.
      trial.resize(increment.size());
      for (unsigned int b = 0; b < trial.size(); ++b)
        trial[b] = factor * increment[b];
      state.move(1., trial);
      for (const auto &contribution : contributions)
        if (contribution->is_rough())
          contribution->probe(state);
      const double rough = rough_part()[0];
      state.set(start);
      return smooth_slope + factor * smooth_curvature + rough;
    }
  } // namespace Solver
} // namespace Heddle
