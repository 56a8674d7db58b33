#ifndef heddle_solver_predictor_h
#define heddle_solver_predictor_h

#include <heddle/base/archive.h>
#include <heddle/system/contribution.h>

#include <vector>

namespace Heddle
{
  namespace Solver
  {
    using namespace dealii;

    /**
     * Guesses where the next load factor takes the fibers: along the line
     * through the last two equilibria or the parabola through the last three,
     * whichever came nearer to the last one from those before it: where fibers
     * jump or friction turns round, a parabola leads astray. Sections keep
     * their shape: of them the rotation vector is guessed so.
     */
    class Predictor
    {
    public:
      /** A path begins: nothing is known but this state. */
      void
      begin(const System::State &state);

      /** An equilibrium was accepted. */
      void
      add(const System::State &state);

      /**
       * The motion from the current configuration to the one that is guessed
       * for the load factor of @p state: of the owned blocks, or nothing where
       * fewer than two equilibria are known.
       *
       * @note Collective.
       */
      System::Increment
      guess(const System::State &state) const;

      /** @note Collective. */
      void
      save(ArchiveWriter &archive, const System::State &state) const;

      void
      load(const ArchiveReader &archive, const System::State &state);

    private:
      struct Point
      {
        double                    load_factor;
        std::vector<Tensor<1, 3>> blocks; /**< owned ones */
      };

      /**
       * What Lagrange's polynomial through the @p n points before point @p end
       * takes of each point at @p load_factor.
       */
      std::vector<double>
      lagrange(const unsigned int end,
               const unsigned int n,
               const double       load_factor) const;

      /**
       * The sum of squares by which @p n points before the last one miss the
       * nodes of the last one [mm^2].
       */
      double
      miss(const System::State &state, const unsigned int n) const;

      unsigned int
      n_points_of_guess(const System::State &state) const;

      /** Of the two section vectors from block @p first on. */
      void
      rotate_section(const std::vector<double> &weights,
                     const unsigned int         first,
                     Tensor<1, 3>              *motion) const;

      std::vector<Point> points; /**< the last ones, in ascending order */
    };
  } // namespace Solver
} // namespace Heddle

#endif
