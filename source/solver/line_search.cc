#include <heddle/base/petsc.h>
#include <heddle/base/reduce.h>
#include <heddle/solver/line_search.h>
#include <heddle/solver/tangent_operator.h>

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
      constexpr double flat = 0.2;

      /** A step is doubled while the slope at its end is steeper than this. */
      constexpr double steep = 0.3;

      /** Forces drive a step if what is raised is a smaller part of its slope.
       */
      constexpr double largest_raised = 0.5;

      /** Places that are tried before the best so far has to do. */
      constexpr unsigned int max_trials = 6;
    } // namespace



    LineSearch::LineSearch(System::State             &state,
                           const NonsmoothTerms      &nonsmooth_terms,
                           const System::BlockSystem &system,
                           const System::Increment   &increment,
                           const double               damping)
      : state(state)
      , nonsmooth_terms(nonsmooth_terms)
      , increment(increment)
      , start(state.current())
    {
      first.slope = slope(system, increment);

      const TangentOperator tangent(system,
                                    System::BlockSystem::Part::symmetric);
      Vec                   image;
      petsc(VecDuplicate(system.solution(), &image));
      petsc(MatMult(tangent.matrix(), system.solution(), image));
      double curvature;
      petsc(VecDot(system.solution(), image, &curvature));
      petsc(VecDestroy(&image));

      const std::array<double, 2> nonsmooth = nonsmooth_part();
      first.curvature  = curvature + raised(system, first.slope) - damping;
      smooth_slope     = first.slope - nonsmooth[0];
      smooth_curvature = first.curvature - nonsmooth[1];
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
    LineSearch::raised(const System::BlockSystem &system, const double slope)
    {
      // The right-hand side is what is unbalanced and what is raised.
      double work;
      petsc(VecDot(system.right_hand_side(), system.solution(), &work));
      return -work - slope;
    }



    bool
    LineSearch::driven_by_forces(const System::BlockSystem &system,
                                 const System::Increment   &increment)
    {
      const double first = slope(system, increment);
      return std::abs(raised(system, first)) < largest_raised * std::abs(first);
    }



    double
    LineSearch::best_step(const double longest)
    {
      // Where the slope is still negative the energy still falls; a small
      // positive one is as good. A model that bends down tells nothing of what
      // lies further.
      const double scale = std::abs(first.slope);
      Place        low = first, high = place_at(std::min(1., longest));
      while (smooth_curvature > 0. && high.slope < -steep * scale &&
             2. * high.factor <= longest)
        {
          const Place next = place_at(2. * high.factor);
          if (next.slope > flat * scale)
            break;
          high = next;
        }

      // Else go to the root of the slope.
      for (unsigned int trial = 0;
           trial < max_trials && high.slope > flat * scale;
           ++trial)
        {
          const double size = high.factor - low.factor;
          const Place  next = place_at(std::clamp(estimate_root(low, high),
                                                 low.factor + 0.1 * size,
                                                 low.factor + 0.9 * size));
          if (next.slope < -flat * scale)
            {
              low = next;
              if (trial + 1 == max_trials)
                return low.factor;
            }
          else
            high = next;
        }
      return high.factor;
    }



    double
    LineSearch::estimate_root(const Place &low, const Place &high)
    {
      // As more and more contacts close the slope grows ever faster: its root
      // lies between that of the chord and the first one of the tangents.
      const double chord = low.factor + (high.factor - low.factor) * low.slope /
                                          (low.slope - high.slope);
      double bound = high.factor;
      for (const Place *place : {&low, &high})
        if (place->curvature > 0.)
          bound =
            std::min(bound, place->factor - place->slope / place->curvature);
      return 0.5 * (chord + std::max(chord, bound));
    }



    std::array<double, 2>
    LineSearch::nonsmooth_part() const
    {
      std::array<double, 2> sum = {};
      for (const auto *term : nonsmooth_terms)
        if (term->is_nonsmooth())
          {
            const auto part = term->slope_and_curvature(state, increment);
            sum[0] += part.first;
            sum[1] += part.second;
          }
      sum_over_ranks(sum, state.space.communicator());
      return sum;
    }



    LineSearch::Place
    LineSearch::place_at(const double factor)
    {
      // As the iteration will move, to the last digit: where it ends here
      // nothing has to be found anew.
      trial.resize(increment.size());
      for (unsigned int b = 0; b < trial.size(); ++b)
        trial[b] = factor * increment[b];
      state.move(1., trial);
      for (auto *term : nonsmooth_terms)
        if (term->is_nonsmooth())
          term->update_trial(state);
      const std::array<double, 2> nonsmooth = nonsmooth_part();
      state.set(start);
      return {factor,
              smooth_slope + factor * smooth_curvature + nonsmooth[0],
              smooth_curvature + nonsmooth[1]};
    }
  } // namespace Solver
} // namespace Heddle
