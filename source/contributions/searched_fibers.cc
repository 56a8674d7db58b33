#include <heddle/contributions/near_fibers.h>
#include <heddle/contributions/searched_fibers.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace Heddle
{
  namespace Contributions
  {
    namespace
    {
      /** Motion after which a fiber is searched anew, in search distances. */
      constexpr double stale_after = 0.1;

      /**
       * No step moves a fiber further. Two fibers may both have moved nearly as
       * far as makes them stale when it begins, and one of them when the pair
       * was searched because of the other one: they still have not met unseen.
       */
      constexpr double longest_step = 0.5 * (1. - 3. * stale_after);

      /** Nor further than this, in sums of radii: two that touch and go each
       * other's way would change their places at 0.5. */
      constexpr double part_of_thickness = 0.35;

      /**
       * Nodes that a rank holds of a foreign fiber beyond those that are near:
       * new pieces need a new search of all pairs.
       */
      constexpr unsigned int spare_nodes = 2;



      /** A third of an interval between nodes [mm]. */
      double
      third_of_interval(const System::Fiber &fiber)
      {
        return fiber.length / (3. * (fiber.n_nodes - 1));
      }



      /**
       * How far the axis may move next to a knot that moves by @p position,
       * while its derivative changes by @p tangent: the control points of the
       * cubics, @p third of an interval away, bound that.
       */
      double
      bound_of_motion(const Tensor<1, 3> &position,
                      const Tensor<1, 3> &tangent,
                      const double        third)
      {
        return std::max((position + third * tangent).norm(),
                        (position - third * tangent).norm());
      }



      /**
       * Control vectors of the derivative of a cubic in arc length, by those of
       * it and its derivative at two knots: the derivative is a mean of them.
       */
      std::array<Tensor<1, 3>, 3>
      control_vectors(const Tensor<1, 3> *positions,
                      const Tensor<1, 3> *tangents,
                      const double        third)
      {
        return {
          {tangents[0],
           (positions[1] - positions[0]) / third - tangents[0] - tangents[1],
           tangents[1]}};
      }



      double
      largest_derivative(const Tensor<1, 3> *positions,
                         const Tensor<1, 3> *tangents,
                         const double        third)
      {
        double largest = 0.;
        for (const auto &vector : control_vectors(positions, tangents, third))
          largest = std::max(largest, vector.norm());
        return largest;
      }



      /** By how much the tangent turns from knot to knot at most [rad]. */
      double
      turn_of_tangents(const Tensor<1, 3> *positions,
                       const Tensor<1, 3> *tangents,
                       const double        third)
      {
        const auto control = control_vectors(positions, tangents, third);
        double     turn    = 0.;
        for (unsigned int k = 0; k < 2; ++k)
          turn +=
            std::atan2(cross_product_3d(control[k], control[k + 1]).norm(),
                       control[k] * control[k + 1]);
        return turn;
      }
    } // namespace



    SearchedFibers::SearchedFibers(const System::FiberSpace &space,
                                   const double              largest_radius,
                                   const double              search_distance)
      : space(space)
      , largest_radius(largest_radius)
      , search_distance(search_distance)
      , stale_motion(stale_after * (search_distance * largest_radius))
      , centerlines(space)
    {
    }



    void
    SearchedFibers::set(const System::State &state)
    {
      centerlines.set(state, state.current());
      all_curves.reset(space.n_fibers());
      for (unsigned int f = 0; f < space.n_fibers(); ++f)
        if (state.has(f))
          all_curves.add(
            {f, space.owns(f), centerlines.curve(f), /*stale=*/false});
    }



    void
    SearchedFibers::measure_motion(const System::State &state)
    {
      moved_by.assign(space.n_fibers(), 0.);
      for (unsigned int f = 0; f < space.n_fibers(); ++f)
        if (state.has(f))
          {
            const double third = third_of_interval(space.fiber(f));
            const auto   knots = centerlines.knots(f);
            for (unsigned int i = knots.first; i < knots.second; ++i)
              moved_by[f] =
                std::max(moved_by[f],
                         bound_of_motion(
                           centerlines.positions()[i] - searched_at[2 * i],
                           centerlines.tangents()[i] - searched_at[2 * i + 1],
                           third));
          }
    }



    bool
    SearchedFibers::needs_search(const System::State &state)
    {
      if (!searched)
        return true;
      // Ranks that hold pieces of a fiber only have to decide alike.
      measure_motion(state);
      Utilities::MPI::max(
        std::vector<double>(moved_by), space.communicator(), moved_by);
      return *std::max_element(moved_by.begin(), moved_by.end()) > stale_motion;
    }



    bool
    SearchedFibers::fetch_near_fibers(System::State &state)
    {
      if (Utilities::MPI::n_mpi_processes(space.communicator()) == 1)
        return false;
      const auto near = find_near_fibers(
        space, centerlines, largest_radius * (1. + 0.5 * search_distance));
      const bool changed = Utilities::MPI::max(holds(state, near) ? 0 : 1,
                                               space.communicator()) > 0;
      if (changed)
        state.set_ghost_fibers(lengthened(space, near, spare_nodes));
      return changed;
    }



    bool
    SearchedFibers::begin_search(System::State &state)
    {
      const bool changed = fetch_near_fibers(state);
      set(state);
      if (changed || !searched)
        {
          searched_at.resize(2 * centerlines.positions().size());
          moved_by.assign(space.n_fibers(), std::numeric_limits<double>::max());
        }
      for (unsigned int f = 0; f < space.n_fibers(); ++f)
        if (state.has(f) && moved_by[f] > stale_motion)
          {
            const auto knots = centerlines.knots(f);
            for (unsigned int i = knots.first; i < knots.second; ++i)
              {
                searched_at[2 * i]     = centerlines.positions()[i];
                searched_at[2 * i + 1] = centerlines.tangents()[i];
              }
            all_curves.set_stale(f);
            moved_by[f] = 0.;
          }
      searched = true;
      return changed;
    }



    bool
    SearchedFibers::hold_all() const
    {
      return Utilities::MPI::n_mpi_processes(space.communicator()) == 1;
    }



    void
    SearchedFibers::find_motion(const unsigned int       f,
                                const System::State     &state,
                                const System::Increment &increment,
                                Motion                  &motion) const
    {
      const System::Fiber &fiber = space.fiber(f);
      motion.positions.resize(fiber.n_nodes);
      motion.tangents.resize(fiber.n_nodes);
      space.centerline_knots(f,
                             space.all_nodes(f),
                             increment.data() + state.local_block(f),
                             motion.positions.data(),
                             motion.tangents.data());
      const double third = third_of_interval(fiber);
      motion.furthest    = 0.;
      for (unsigned int i = 0; i < fiber.n_nodes; ++i)
        motion.furthest = std::max(
          motion.furthest,
          bound_of_motion(motion.positions[i], motion.tangents[i], third));

      // Surfaces move with the vectors of the sections too.
      if (space.n_blocks_per_node() == 3)
        for (unsigned int b = 0; b < space.n_blocks(f); ++b)
          if (b % 3 > 0)
            motion.furthest = std::max(
              motion.furthest,
              fiber.radius * increment[state.local_block(f) + b].norm());
    }



    double
    SearchedFibers::searched_step(const System::State       &state,
                                  const System::Increment   &increment,
                                  const std::vector<double> &thickness) const
    {
      // Nothing may leave the range within which all pairs are known.
      double     factor = std::numeric_limits<double>::max();
      Motion     motion;
      const auto owned = space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          find_motion(f, state, increment, motion);
          const double allowed =
            std::min(longest_step * search_distance * largest_radius,
                     part_of_thickness * thickness[f]);
          factor =
            std::min(factor, allowed / std::max(motion.furthest, 1e-300));
        }
      return factor;
    }



    double
    SearchedFibers::clear_step(const System::State     &state,
                               const System::Increment &increment) const
    {
      // An arc that turns by no more than 60 degrees lies within 30 of one
      // direction, and within 60 if its tangents turn by 30: along that it goes
      // on, and does not meet itself.
      double furthest = 0., turn = 0., bend = 0., interval = 0.;
      Motion motion;
      for (unsigned int f = 0; f < space.n_fibers(); ++f)
        {
          find_motion(f, state, increment, motion);
          const double third = third_of_interval(space.fiber(f));
          const auto   knots = centerlines.knots(f);
          furthest           = std::max(furthest, motion.furthest);
          interval           = std::max(interval, 3. * third);
          for (unsigned int i = 0; i + 1 < motion.positions.size(); ++i)
            {
              const unsigned int k = knots.first + i;
              turn                 = std::max(turn,
                              largest_derivative(motion.positions.data() + i,
                                                 motion.tangents.data() + i,
                                                 third));
              bend =
                std::max(bend,
                         turn_of_tangents(centerlines.positions().data() + k,
                                          centerlines.tangents().data() + k,
                                          third) /
                           (3. * third));
            }
        }
      const double most = std::min(1., 0.5 / std::max(turn, 1e-300));
      const double window =
        numbers::PI / 3. / std::max(bend, 1e-300) - interval;
      const double known = search_distance * largest_radius;
      double       clear = most * furthest / longest_step;
      while (clear > known &&
             !Contact::are_apart(all_curves.all(), clear, window))
        clear *= 0.5;
      return std::min(most,
                      longest_step * std::max(clear, known) /
                        std::max(furthest, 1e-300));
    }
  } // namespace Contributions
} // namespace Heddle
