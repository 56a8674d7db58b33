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
     * Guesses where the next load factor takes the fibers: along the parabola
     * through the last three equilibria, or the line through the last two.
     * Sections keep their shape: of them the rotation vector is guessed so.
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
