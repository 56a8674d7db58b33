#include <heddle/solver/equations.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /**
       * So much of the size of a scene are positions off in a solved system,
       * for they have no more digits: the last one, and some more by the
       * solver. On a cantilever of 256 elements it was up to 50 in Debug.
       */
      constexpr double last_digits =
        256. * std::numeric_limits<double>::epsilon();



      /** The largest distance of a node from the origin [mm]. */
      double
      size_of_scene(const System::State &state)
      {
        double size = 0.;
        for (unsigned int b = 0; b < state.n_owned_fiber_blocks();
             b += state.space.n_blocks_per_node())
          size = std::max(size, state.current()[b].norm());
        for (unsigned int b = state.n_owned_fiber_blocks();
             b < state.n_owned_blocks();
             ++b)
          size = std::max(size, state.current()[b].norm());
        return Utilities::MPI::max(size, state.space.communicator());
      }



      /** Forces that are the last digits of positions [N]. */
      System::NodeStiffness
      negligible_forces(const System::State &state,
                        const Contributions &contributions)
      {
        System::NodeStiffness negligible;
        negligible.of_fibers.assign(state.space.n_fibers(), 0.);
        for (const auto &contribution : contributions)
          contribution->raise_stiffness(negligible);
        const double last_digit = last_digits * size_of_scene(state);
        for (double &force : negligible.of_fibers)
          force *= last_digit;
        negligible.of_matrix *= last_digit;
        return negligible;
      }
    } // namespace



    Equations::Equations(System::State       &state,
                         const Contributions &contributions,
                         System::BlockSystem &system,
                         SectionTimer        &timer)
      : state(state)
      , contributions(contributions)
      , nonsmooth(nonsmooth_terms(contributions))
      , system(system)
      , communicator(state.space.communicator())
      , length_scale(state.space.smallest_radius())
      , timer(timer)
      , negligible(negligible_forces(state, contributions))
    {
    }



    void
    Equations::collect_constraints()
    {
      constraints.clear();
      for (const auto &contribution : contributions)
        contribution->constrain(state, constraints);
    }



    void
    Equations::update()
    {
      for (auto *term : nonsmooth)
        term->update(state);
      collect_constraints();
    }



    void
    Equations::prepare()
    {
      SectionTimer::Scope scope(timer, "detection");
      update();
      for (auto *term : nonsmooth)
        term->begin_iteration(state);

      bool stale = !system.has_pattern();
      for (const auto *term : nonsmooth)
        stale = term->needs_new_pattern() || stale;
      if (Utilities::MPI::max(stale ? 1 : 0, communicator) > 0)
        {
          System::BlockPattern pattern(state.n_owned_blocks(),
                                       system.keeps_couplings_apart());
          for (const auto &contribution : contributions)
            contribution->add_pattern(state, pattern);
          system.set_pattern(pattern);
        }
      system.set_constraints(constraints);
    }



    void
    Equations::assemble(const System::BlockSystem::Want want)
    {
      SectionTimer::Scope scope(timer, "assembly");
      system.begin(want);
      for (const auto &contribution : contributions)
        contribution->assemble(state, system);
    }



    Residual
    Equations::judge() const
    {
      return Solver::judge(system, contributions, constraints, negligible);
    }



    Residual
    Equations::judge_without_tangent()
    {
      {
        SectionTimer::Scope scope(timer, "detection");
        update();
        system.set_constraints(constraints);
      }
      assemble(System::BlockSystem::Want::residual);
      return judge();
    }



    double
    Equations::pending_motion()
    {
      collect_constraints();
      return Solver::pending_motion(constraints, communicator);
    }



    bool
    Equations::is_nonsmooth() const
    {
      return Solver::is_nonsmooth(nonsmooth);
    }



    bool
    Equations::is_credible() const
    {
      return std::all_of(nonsmooth.begin(),
                         nonsmooth.end(),
                         [](const auto *one) { return one->is_credible(); });
    }



    void
    Equations::set_softness(const double value)
    {
      softness_of_terms = value;
      for (auto *term : nonsmooth)
        term->set_softness(value);
    }



    void
    Equations::set_geometric_stiffness(const bool wanted)
    {
      for (auto *term : nonsmooth)
        term->set_geometric_stiffness(wanted);
    }



    bool
    Equations::adapt()
    {
      bool changed = false;
      for (auto *term : nonsmooth)
        changed = term->adapt(state) || changed;
      return changed;
    }



    std::string
    Equations::objection() const
    {
      std::string objection;
      for (const auto &contribution : contributions)
        if (objection.empty())
          objection = contribution->objection(state);
      return objection;
    }



    double
    Equations::largest_step(const System::Increment &increment) const
    {
      double largest = std::numeric_limits<double>::max();
      for (const auto &contribution : contributions)
        largest =
          std::min(largest, contribution->largest_step(state, increment));
      return Utilities::MPI::min(largest, communicator);
    }



    double
    Equations::searched_step(const System::Increment &increment) const
    {
      double searched = std::numeric_limits<double>::max();
      for (const auto *term : nonsmooth)
        searched = std::min(searched, term->searched_step(state, increment));
      return Utilities::MPI::min(searched, communicator);
    }
  } // namespace Solver
} // namespace Heddle
