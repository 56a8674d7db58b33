#include <heddle/base/reduce.h>
#include <heddle/contributions/plates.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Heddle
{
  namespace Contributions
  {
    namespace
    {
      /** Points within one radius of a fiber. */
      constexpr double points_per_radius = 8.;

      /** A penalty aims below the threshold, lest it has to be raised again. */
      constexpr double aim = 0.75;

      /** No guess is followed that lays fibers so deep in a plate, in radii, or
       * leaves less than this part of what touched it. */
      constexpr double deepest_credible = 0.3, least_left = 0.1;

      /** A plate that no fiber comes so near to is none [radii]. */
      constexpr double reach = 0.3;

      /** Largest factor by which a penalty grows at once, and in all. */
      constexpr double growth_at_once = 4., growth_in_all = 1e7;



      /** Material points of an interval of fiber @p f, each amid its part. */
      unsigned int
      n_places(const System::FiberSpace &space,
               const unsigned int        f,
               const unsigned int        interval)
      {
        const double *const s = space.node_positions(f) + interval;
        return std::ceil(points_per_radius * (s[1] - s[0]) /
                         space.fiber(f).radius);
      }



      /** Call @p action (place, s), s the arc length, for those of a fiber. */
      template <typename Action>
      void
      for_each_place(const System::FiberSpace &space,
                     const unsigned int        f,
                     const Action             &action)
      {
        const double *const s = space.node_positions(f);
        for (unsigned int i = 0; i + 1 < space.fiber(f).n_nodes; ++i)
          for (unsigned int k = 0; k < n_places(space, f, i); ++k)
            {
              const double at =
                s[i] + (k + 0.5) / n_places(space, f, i) * (s[i + 1] - s[i]);
              action(space.locate(f, at), at);
            }
      }



      /** A cubic of 0 <= t <= 1. */
      class Cubic
      {
      public:
        /** @p y are its values at 0, 1/3, 2/3 and 1. */
        explicit Cubic(const std::array<double, 4> &y)
          : c{{y[0],
               0.5 * (-11. * y[0] + 18. * y[1] - 9. * y[2] + 2. * y[3]),
               0.5 * (18. * y[0] - 45. * y[1] + 36. * y[2] - 9. * y[3]),
               4.5 * (y[3] - y[0] + 3. * (y[1] - y[2]))}}
        {
        }

        double
        value(const double t) const
        {
          return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
        }

        /** The control points of Bezier's form, between which all values are.
         */
        std::array<double, 4>
        control_points() const
        {
          return {{c[0],
                   c[0] + c[1] / 3.,
                   c[0] + (2. * c[1] + c[2]) / 3.,
                   value(1.)}};
        }

        /** No value is larger. */
        double
        bound() const
        {
          const auto points = control_points();
          return *std::max_element(points.begin(), points.end());
        }

      private:
        const std::array<double, 4> c;
      };
    } // namespace



    Plates::Plates(const System::FiberSpace            &space,
                   const PlateParameters               &parameters,
                   const double                         threshold,
                   const std::optional<BoundingBox<2>> &covered)
      : space(space)
      , compression(parameters.compression, PlateParameters::entry)
      , threshold(threshold)
      , covered(covered)
    {
      const auto owned = space.owned_fibers();
      touches.resize(n_plates * (owned.second - owned.first));
      for (unsigned int k = 0; k < touches.size(); ++k)
        touches[k].penalty = first_penalty(fiber_of(k));
      accepted_touches = touches;
    }



    double
    Plates::first_penalty(const unsigned int f) const
    {
      // Hertz' line contact of a cylinder with something rigid,
      // p = pi/4 E d.
      const System::Fiber &fiber = space.fiber(f);
      return fiber.section.axial / (4. * fiber.radius * fiber.radius);
    }



    Contact::NormalLaw
    Plates::law(const unsigned int touch) const
    {
      return {0.5 * threshold * space.fiber(fiber_of(touch)).radius};
    }



    double
    Plates::force(const TouchingPoint &point) const
    {
      return point.length *
             law(point.touch)
               .pressure(touches[point.touch].penalty, point.penetration);
    }



    Plates::Both<double>
    Plates::positions(const double load_factor) const
    {
      const double approach = 0.5 * (begin[1] - begin[0]) *
                              compression.value(Tensor<1, 3>(), load_factor);
      return {{begin[0] + approach, begin[1] - approach}};
    }



    void
    Plates::cover(const System::State &state)
    {
      for (unsigned int k = 0; k < touches.size(); ++k)
        {
          const unsigned int f = fiber_of(k);
          touches[k].begin     = space.fiber(f).length;
          touches[k].end       = 0.;
          for_each_place(
            space, f, [&](const System::MaterialPoint &place, const double at) {
              const Tensor<1, 3> x = place.position(state.fiber(f));
              if (covered && !covered->point_inside(Point<2>(x[0], x[1])))
                return;
              touches[k].begin = std::min(touches[k].begin, at);
              touches[k].end   = std::max(touches[k].end, at);
            });
        }
    }



    void
    Plates::begin_stage(const System::State &state)
    {
      cover(state);
      // Outwards of what is lowest, and of what is highest.
      begin.fill(-std::numeric_limits<double>::max());
      for (unsigned int k = 0; k < touches.size(); ++k)
        {
          const unsigned int f = fiber_of(k);
          for_each_place(
            space, f, [&](const System::MaterialPoint &place, const double s) {
              if (s >= touches[k].begin && s <= touches[k].end)
                begin[k % n_plates] =
                  std::max(begin[k % n_plates],
                           outwards(k) * place.position(state.fiber(f))[2] +
                             space.fiber(f).radius);
            });
        }
      max_over_ranks(begin, space.communicator());
      begin[0]           = -begin[0];
      accepted_touches   = touches;
      accepted_positions = positions(state.load_factor);
    }



    void
    Plates::update(System::State &state)
    {
      place_points(state);
      gather_sums();
      reached = is_reached(state);
    }



    std::array<double, 4>
    Plates::outwards_along(const Tensor<1, 3> *blocks,
                           const unsigned int  touch,
                           const unsigned int  interval) const
    {
      const unsigned int    f = fiber_of(touch);
      const double *const   s = space.node_positions(f) + interval;
      std::array<double, 4> values;
      for (unsigned int i = 0; i < 4; ++i)
        values[i] =
          outwards(touch) *
          space.locate(f, s[0] + i / 3. * (s[1] - s[0])).position(blocks)[2];
      return values;
    }



    std::array<double, 4>
    Plates::depths_along(const System::State &state,
                         const unsigned int   touch,
                         const unsigned int   interval,
                         const double         plate) const
    {
      const unsigned int    f = fiber_of(touch);
      std::array<double, 4> depths =
        outwards_along(state.fiber(f), touch, interval);
      for (double &depth : depths)
        depth += space.fiber(f).radius - outwards(touch) * plate;
      return depths;
    }



    template <typename Action>
    void
    Plates::for_each_covered(const Action &action) const
    {
      for (unsigned int k = 0; k < touches.size(); ++k)
        {
          const unsigned int  f = fiber_of(k);
          const double *const s = space.node_positions(f);
          for (unsigned int i = 0; i + 1 < space.fiber(f).n_nodes; ++i)
            if (s[i + 1] > touches[k].begin && s[i] < touches[k].end)
              action(k, i);
        }
    }



    bool
    Plates::is_reached(const System::State &state) const
    {
      const Both<double> plates = positions(state.load_factor);
      bool               found  = !points.empty();
      for_each_covered([&](const unsigned int k, const unsigned int i) {
        // Not all have to be looked at.
        found = found ||
                Cubic(depths_along(state, k, i, plates[k % n_plates])).bound() >
                  -reach * space.fiber(fiber_of(k)).radius;
      });
      return Utilities::MPI::logical_or(found, space.communicator());
    }



    double
    Plates::searched_step(const System::State     &state,
                          const System::Increment &increment) const
    {
      double longest = std::numeric_limits<double>::max();
      if (reached)
        return longest;
      // Within reach, but not yet in contact.
      const Both<double> plates = positions(state.load_factor);
      for_each_covered([&](const unsigned int k, const unsigned int i) {
        const unsigned int f = fiber_of(k);
        const auto         depths =
          Cubic(depths_along(state, k, i, plates[k % n_plates]))
            .control_points();
        const auto motions =
          Cubic(outwards_along(increment.data() + state.local_block(f), k, i))
            .control_points();
        for (unsigned int j = 0; j < 4; ++j)
          if (motions[j] > 0.)
            longest = std::min(
              longest,
              (-0.5 * reach * space.fiber(f).radius - depths[j]) / motions[j]);
      });
      return longest;
    }



    void
    Plates::place_points(const System::State &state)
    {
      const Both<double> plates = positions(state.load_factor);
      points.clear();
      for (unsigned int k = 0; k < touches.size(); ++k)
        {
          touches[k].penetration = touches[k].force = touches[k].energy = 0.;
          const unsigned int  f     = fiber_of(k);
          const double *const s     = space.node_positions(f);
          const Tensor<1, 3> *q     = state.fiber(f);
          const double        plate = plates[k % n_plates];
          const auto          depth = [&](const unsigned int node) {
            return space.fiber(f).radius +
                   outwards(k) *
                     (q[node * space.n_blocks_per_node()][2] - plate);
          };
          // Between two nodes a fiber gets no further than it is long.
          for (unsigned int i = 0; i + 1 < space.fiber(f).n_nodes; ++i)
            if (std::max(depth(i), depth(i + 1)) > s[i] - s[i + 1])
              place_points(state, k, i, plate);
        }
    }



    void
    Plates::place_points(const System::State &state,
                         const unsigned int   touch,
                         const unsigned int   interval,
                         const double         plate)
    {
      const unsigned int  f   = fiber_of(touch);
      Touch              &sum = touches[touch];
      const double *const s   = space.node_positions(f) + interval;
      const double        h   = s[1] - s[0];
      const Cubic         cubic(depths_along(state, touch, interval, plate));
      if (cubic.bound() <= 0.)
        return;

      const unsigned int n = n_places(space, f, interval);
      for (unsigned int i = 0; i < n; ++i)
        {
          const double  t  = (i + 0.5) / n;
          const double  at = s[0] + t * h;
          TouchingPoint point;
          point.penetration = cubic.value(t);
          if (point.penetration <= 0. || at < sum.begin || at > sum.end)
            continue;
          const System::MaterialPoint place = space.locate(f, at);
          point.touch                       = touch;
          point.interval                    = interval;
          point.values                      = place.values;
          point.length                      = h / n;
          for (unsigned int j = 0; j < place.blocks.size(); ++j)
            point.blocks[j] = state.local_block(f) + place.blocks[j];
          sum.penetration = std::max(sum.penetration, point.penetration);
          sum.force += force(point);
          sum.energy +=
            point.length * law(touch).energy(sum.penalty, point.penetration);
          points.push_back(point);
        }
    }



    void
    Plates::gather_sums()
    {
      sums    = {};
      deepest = 0.;
      for (unsigned int k = 0; k < touches.size(); ++k)
        {
          sums.force[k % n_plates] += touches[k].force;
          sums.energy += touches[k].energy;
          deepest = std::max(deepest, in_radii(k));
        }
      for (auto point = points.begin(); point != points.end(); ++point)
        if (point == points.begin() || point->touch != (point - 1)->touch ||
            point->interval > (point - 1)->interval + 1)
          sums.n_stretches += 1.;
      sum_over_ranks(sums, space.communicator());
      max_over_ranks(deepest, space.communicator());
    }



    void
    Plates::add_pattern(const System::State  &state,
                        System::BlockPattern &pattern)
    {
      // Places touch and part: all that may are in the pattern at once.
      for (unsigned int k = 0; k < touches.size(); k += n_plates)
        for (unsigned int i = 0; i + 1 < space.fiber(fiber_of(k)).n_nodes; ++i)
          {
            const unsigned int f = fiber_of(k);
            auto blocks          = space.locate(f, space.middle(f, i)).blocks;
            for (unsigned int &block : blocks)
              block += state.local_block(f);
            pattern.couple(blocks.size(), blocks.data());
          }
    }



    void
    Plates::assemble(const System::State &, System::BlockSystem &system)
    {
      std::array<double, 12>  residual;
      std::array<double, 144> tangent;
      for (auto point = points.begin(); point != points.end();)
        {
          // Those of an interval are of the same blocks.
          const auto first = point;
          residual.fill(0.);
          tangent.fill(0.);
          for (; point != points.end() && point->touch == first->touch &&
                 point->interval == first->interval;
               ++point)
            {
              const double pushes = outwards(point->touch) * force(*point);
              const double stiffness =
                point->length *
                law(point->touch)
                  .stiffness(touches[point->touch].penalty, point->penetration);
              for (unsigned int i = 0; i < 4; ++i)
                {
                  residual[3 * i + 2] += pushes * point->values[i];
                  for (unsigned int j = 0; j < 4; ++j)
                    tangent[12 * (3 * i + 2) + 3 * j + 2] +=
                      stiffness * point->values[i] * point->values[j];
                }
            }
          system.add(4, first->blocks.data(), residual.data(), tangent.data());
        }
    }



    std::pair<double, double>
    Plates::slope_and_curvature(const System::State &,
                                const System::Increment &increment) const
    {
      double slope = 0., curvature = 0.;
      for (const TouchingPoint &point : points)
        {
          double sinks = 0.;
          for (unsigned int i = 0; i < 4; ++i)
            sinks += outwards(point.touch) * point.values[i] *
                     increment[point.blocks[i]][2];
          slope += force(point) * sinks;
          curvature +=
            point.length *
            law(point.touch)
              .stiffness(touches[point.touch].penalty, point.penetration) *
            sinks * sinks;
        }
      return {slope, curvature};
    }



    bool
    Plates::is_credible() const
    {
      return deepest <= deepest_credible &&
             sums.n_stretches >= least_left * accepted_stretches;
    }



    bool
    Plates::adapt(const System::State &)
    {
      if (softness > 0.)
        return false;
      bool changed = false;
      for (unsigned int k = 0; k < touches.size(); ++k)
        {
          Touch       &touch = touches[k];
          const double depth = in_radii(k);
          const double most  = growth_in_all * first_penalty(fiber_of(k));
          if (depth <= threshold || touch.penalty >= most)
            continue;
          const double growth = std::min(
            {depth / (aim * threshold), growth_at_once, most / touch.penalty});
          touch.penalty *= growth;
          touch.hardened *= growth;
          changed = true;
        }
      return Utilities::MPI::logical_or(changed, space.communicator());
    }



    std::string
    Plates::objection(const System::State &) const
    {
      if (deepest <= threshold)
        return "";
      std::ostringstream text;
      text << "fibers are " << deepest << " radii deep in the plates, above "
           << threshold;
      return text.str();
    }



    void
    Plates::accept_step(const System::State &state)
    {
      hardening += energy_of_hardening();
      const Both<double> now = positions(state.load_factor);
      for (unsigned int plate = 0; plate < n_plates; ++plate)
        work += 0.5 * (accepted_force[plate] + sums.force[plate]) *
                outwards(plate) * (accepted_positions[plate] - now[plate]);
      accepted_force     = sums.force;
      accepted_stretches = sums.n_stretches;
      largest_mean_force = std::max(largest_mean_force, mean_force());
      accepted_positions = now;
      for (Touch &touch : touches)
        touch.hardened = 1.;
      accepted_touches = touches;
    }



    void
    Plates::reject_step(System::State &)
    {
      touches = accepted_touches;
      points.clear();
    }
  } // namespace Contributions
} // namespace Heddle
