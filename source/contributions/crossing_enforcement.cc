#include <heddle/base/reduce.h>
#include <heddle/contributions/crossing_enforcement.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <tuple>

namespace Heddle
{
  namespace Contributions
  {
    namespace
    {
      /** Where the normal law becomes linear, in radii. */
      constexpr double transition = 0.05;

      /** Largest c: two fibers that both climb by 45 degrees. */
      const double steepest = std::sqrt(3.);

      /** What overlaps less than this is apart, however far it is [mm]. */
      constexpr double apart = -std::numeric_limits<double>::max();

    } // namespace



    CrossingEnforcement::CrossingEnforcement(
      const System::FiberSpace        &space,
      const std::vector<OrderedYarns> &crossings)
      : space(space)
      , centerlines(space)
    {
      for (const OrderedYarns &yarns : crossings)
        enforced_yarns.emplace_back(yarns.upper, yarns.lower);
      std::sort(enforced_yarns.begin(), enforced_yarns.end());
      enforced_yarns.erase(
        std::unique(enforced_yarns.begin(), enforced_yarns.end()),
        enforced_yarns.end());

      std::vector<std::vector<unsigned int>> fibers(space.n_yarns());
      for (unsigned int f = 0; f < space.n_fibers(); ++f)
        if (space.fiber(f).yarn_id < fibers.size())
          fibers[space.fiber(f).yarn_id].push_back(f);
      for (const auto &yarns : enforced_yarns)
        for (const unsigned int i : fibers[yarns.first])
          for (const unsigned int j : fibers[yarns.second])
            if (space.owns(i) || space.owns(j))
              pairs.push_back({i, j, {}, 1.});
      // Forces do not depend on who sums them.
      std::sort(pairs.begin(), pairs.end(), [](const Pair &a, const Pair &b) {
        return std::tie(a.upper, a.lower) < std::tie(b.upper, b.lower);
      });
    }



    bool
    CrossingEnforcement::enforces(const unsigned int a,
                                  const unsigned int b) const
    {
      return puts_above(a, b) || puts_above(b, a);
    }



    bool
    CrossingEnforcement::puts_above(const unsigned int a,
                                    const unsigned int b) const
    {
      return std::binary_search(
        enforced_yarns.begin(),
        enforced_yarns.end(),
        std::make_pair(space.fiber(a).yarn_id, space.fiber(b).yarn_id));
    }



    double
    CrossingEnforcement::largest_overlap(System::State &state)
    {
      centerlines.set(state, state.current());
      double largest = apart;
      for (Pair &pair : pairs)
        largest = std::max(largest, overlap(pair));
      return Utilities::MPI::max(largest, space.communicator());
    }



    void
    CrossingEnforcement::end()
    {
      pairs.clear();
      elements.clear();
      n_overlapping = mean_force = energy = deepest = 0.;
    }



    void
    CrossingEnforcement::begin_step(System::State &state)
    {
      centerlines.set(state, state.current());
      for (Pair &pair : pairs)
        {
          if (overlap(pair) > apart)
            pair.climb = std::min(pair.crossing.normal.norm(), steepest);
        }
    }



    void
    CrossingEnforcement::update(System::State &state)
    {
      place_elements(state);
      gather_statistics();
    }



    double
    CrossingEnforcement::overlap(Pair &pair) const
    {
      if (!Contact::find_projected_crossing(centerlines.curve(pair.upper),
                                            centerlines.curve(pair.lower),
                                            pair.crossing))
        return apart;
      return pair.climb * (space.fiber(pair.upper).radius +
                           space.fiber(pair.lower).radius) -
             pair.crossing.height;
    }



    void
    CrossingEnforcement::place_elements(const System::State &state)
    {
      centerlines.set(state, state.current());
      elements.clear();
      for (Pair &pair : pairs)
        {
          Assert(state.held_nodes(pair.upper) == space.all_nodes(pair.upper) &&
                   state.held_nodes(pair.lower) == space.all_nodes(pair.lower),
                 ExcMessage("Fibers that cross are not held whole."));
          const double penetration = overlap(pair) - allowance;
          if (penetration > 0.)
            elements.push_back(make_element(state, pair, penetration));
        }
    }



    CrossingEnforcement::Element
    CrossingEnforcement::make_element(const System::State &state,
                                      const Pair          &pair,
                                      const double         penetration) const
    {
      Element                           element;
      const Contact::ProjectedCrossing &crossing = pair.crossing;
      const System::Fiber              &upper    = space.fiber(pair.upper);
      const System::Fiber              &lower    = space.fiber(pair.lower);
      const System::MaterialPoint       on_upper =
        space.locate(pair.upper, crossing.s_a);
      const System::MaterialPoint on_lower =
        space.locate(pair.lower, crossing.s_b);
      for (unsigned int i = 0; i < 4; ++i)
        {
          element.blocks[i] =
            state.local_block(pair.upper) + on_upper.blocks[i];
          element.blocks[4 + i] =
            state.local_block(pair.lower) + on_lower.blocks[i];
          element.direction[i]     = on_upper.values[i] * crossing.normal;
          element.direction[4 + i] = -on_lower.values[i] * crossing.normal;
        }
      element.intervals = {pair.upper,
                           pair.lower,
                           space.interval(pair.upper, crossing.s_a),
                           space.interval(pair.lower, crossing.s_b)};
      element.own       = space.owns(pair.upper);

      // Line contact of two elastic cylinders, as long as they are wide.
      const auto compliance = [](const System::Fiber &fiber) {
        return numbers::PI * fiber.radius * fiber.radius / fiber.section.axial;
      };
      element.penetration = penetration;
      element.penalty     = numbers::PI / 4. * (upper.radius + lower.radius) /
                        (compliance(upper) + compliance(lower));
      element.law = {transition * std::min(upper.radius, lower.radius)};
      return element;
    }



    void
    CrossingEnforcement::gather_statistics()
    {
      struct
      {
        double n = 0., force = 0., energy = 0.;
      } sums;
      deepest = 0.;
      for (const Element &element : elements)
        if (element.own)
          {
            sums.n += 1.;
            sums.force += element.force();
            sums.energy +=
              element.law.energy(element.penalty, element.penetration);
            deepest = std::max(deepest,
                               element.penetration * transition /
                                 element.law.transition);
          }
      sum_over_ranks(sums, space.communicator());
      max_over_ranks(deepest, space.communicator());
      n_overlapping = sums.n;
      mean_force    = n_overlapping > 0. ? sums.force / n_overlapping : 0.;
      energy        = sums.energy;
    }



    std::vector<Contact::CandidatePair>
    CrossingEnforcement::intervals() const
    {
      std::vector<Contact::CandidatePair> result;
      for (const Element &element : elements)
        result.push_back(element.intervals);
      Contact::sort_and_unify(result);
      return result;
    }



    bool
    CrossingEnforcement::needs_new_pattern() const
    {
      const std::vector<Contact::CandidatePair> needed = intervals();
      return !std::includes(pattern_intervals.begin(),
                            pattern_intervals.end(),
                            needed.begin(),
                            needed.end());
    }



    void
    CrossingEnforcement::add_pattern(const System::State &,
                                     System::BlockPattern &pattern)
    {
      pattern_intervals = intervals();
      for (const Element &element : elements)
        pattern.couple(8, element.blocks.data());
    }



    void
    CrossingEnforcement::assemble(const System::State &,
                                  System::BlockSystem &system)
    {
      std::array<double, 24>  direction, residual;
      std::array<double, 576> tangent;
      for (const Element &element : elements)
        {
          for (unsigned int i = 0; i < 24; ++i)
            {
              direction[i] = element.direction[i / 3][i % 3];
              residual[i]  = -element.force() * direction[i];
            }
          for (unsigned int i = 0; i < 24 && system.wants_tangent(); ++i)
            for (unsigned int j = 0; j < 24; ++j)
              tangent[24 * i + j] =
                element.stiffness() * direction[i] * direction[j];
          system.add(8, element.blocks.data(), residual.data(), tangent.data());
        }
    }



    std::pair<double, double>
    CrossingEnforcement::slope_and_curvature(
      const System::State &,
      const System::Increment &increment) const
    {
      double slope = 0., curvature = 0.;
      for (const Element &element : elements)
        if (element.own)
          {
            double opening = 0.;
            for (unsigned int i = 0; i < 8; ++i)
              opening += element.direction[i] * increment[element.blocks[i]];
            slope -= element.force() * opening;
            curvature += element.stiffness() * opening * opening;
          }
      return {slope, curvature};
    }



    std::string
    CrossingEnforcement::status() const
    {
      std::ostringstream text;
      text << "enforced " << static_cast<unsigned long>(n_overlapping)
           << std::scientific << std::setprecision(1) << " by " << deepest;
      return text.str();
    }



    void
    CrossingEnforcement::report(const System::State &,
                                std::map<std::string, double> &values) const
    {
      values["enforced_crossings[-]"]             = n_overlapping;
      values["max_enforced_penetration_ratio[-]"] = deepest;
      values["enforcement_energy[N*mm]"]          = energy;
    }
  } // namespace Contributions
} // namespace Heddle
