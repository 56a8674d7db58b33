#ifndef heddle_simulation_stage_h
#define heddle_simulation_stage_h

#include <heddle/base/log.h>
#include <heddle/base/signals.h>
#include <heddle/base/timer.h>
#include <heddle/post/crossing_order.h>
#include <heddle/solver/load_stepping.h>
#include <heddle/solver/newton.h>

#include <functional>
#include <string>

namespace Heddle
{
  namespace Simulation
  {
    /** What a stage is for. */
    enum class StageKind
    {
      order,
      approach,
      settle,
      load
    };

    /** The name of a stage, unless it is a load case with its own. */
    constexpr const char *
    word(const StageKind kind)
    {
      switch (kind)
        {
          case StageKind::order:
            return "order";
          case StageKind::approach:
            return "approach";
          case StageKind::settle:
            return "settle";
          case StageKind::load:
            return "load";
        }
      return nullptr;
    }



    /**
     * A part of a computation with its own equilibrium: which contributions
     * are in force, and how the load factor goes from 0 to 1.
     */
    struct Stage
    {
      Stage(const StageKind kind)
        : kind(kind)
        , name(word(kind))
      {
      }

      StageKind             kind;
      std::string           name;
      Solver::Contributions contributions;
      Solver::LoadPlan      plan;
      Solver::Aim           aim = Solver::Aim::equilibrium;

      /**
       * Whether loads and supports act: forces at its beginning count for the
       * work of its steps, and each step is guessed from those before it.
       */
      bool
      is_loaded() const
      {
        return kind == StageKind::load;
      }

      /** Whether it begins in the initial configuration, as all cases do. */
      bool begins_initially = false;

      /** Where points of a fabric that it bends are if this is flat again. */
      PointMap flattened;

      /** Prepares the scene when the stage begins, not when it is resumed. */
      std::function<void()> begin = [] {};

      /** Makes the contributions ready for a step to this load factor. */
      std::function<void(const double)> set_up = [](const double) {};

      /** Takes a step another way than to the equilibrium, if given. */
      std::function<Solver::NewtonResult(Log &, SectionTimer &, StopRequest &)>
        solve;

      /**
       * Why what was reached at load factor 1, in a loaded stage by any step,
       * is not the aim, where fibers cross so, or nothing.
       */
      std::function<std::string(const Post::CrossingCount &)> objection =
        [](const Post::CrossingCount &) { return std::string(); };
    };
  } // namespace Simulation
} // namespace Heddle

#endif
