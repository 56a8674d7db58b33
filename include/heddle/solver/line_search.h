#ifndef heddle_solver_line_search_h
#define heddle_solver_line_search_h

#include <heddle/solver/terms.h>

#include <array>
#include <vector>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    /**
     * Looks along the solution of a linear system for the place where the
     * energy stops falling: smooth terms by their quadratic model, of which the
     * tangent is known, nonsmooth ones as they are.
     */
    class LineSearch
    {
    public:
      /**
       * Begin in the current configuration, in which residual and tangent were
       * assembled and solved for @p increment. @p damping is the curvature
       * along it, over all ranks, of what was added to the tangent [N mm].
       * @note Collective, like all of this class.
       */
      LineSearch(System::State             &state,
                 const NonsmoothTerms      &nonsmooth_terms,
                 const System::BlockSystem &system,
                 const System::Increment   &increment,
                 const double               damping);

      /**
       * Derivative of the energy along @p increment but for its prescribed
       * part, as last assembled [N mm].
       * @note Collective.
       */
      static double
      slope(const System::BlockSystem &system,
            const System::Increment   &increment);

      /**
       * Whether unbalanced forces drive @p increment, so that energy falls
       * along it, and not what supports prescribe.
       * @note Collective.
       */
      static bool
      driven_by_forces(const System::BlockSystem &system,
                       const System::Increment   &increment);

      /**
       * Part of the increment to be taken: about 1, less where the energy rises
       * before, more, up to @p longest, where it still falls steeply.
       */
      double
      best_step(const double longest);

    private:
      /**
       * By how much the prescribed part of the increment changes the @p slope
       * along the rest of it, from beginning to end [N mm].
       */
      static double
      raised(const System::BlockSystem &system, const double slope);

      /** Slope and curvature of the nonsmooth terms in the current state. */
      std::array<double, 2>
      nonsmooth_part() const;

      /** The whole energy after a part of the step, in its direction. */
      struct Place
      {
        double factor, slope, curvature; /**< [-], [N mm], [N mm] */
      };

      Place
      place_at(const double factor);

      /** Between two places: less than the root of the slope, or more. */
      static double
      estimate_root(const Place &low, const Place &high);

      System::State                  &state;
      const NonsmoothTerms           &nonsmooth_terms;
      const System::Increment        &increment;
      const std::vector<Tensor<1, 3>> start;
      System::Increment               trial;
      Place                           first            = {};
      double                          smooth_slope     = 0.;
      double                          smooth_curvature = 0.;
    };
  } // namespace Solver
} // namespace Heddle

#endif
