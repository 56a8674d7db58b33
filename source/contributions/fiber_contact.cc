#include <heddle/base/reduce.h>
#include <heddle/contributions/fiber_contact.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Heddle
{
  namespace Contributions
  {
    namespace
    {
      /** Motion after which fibers are searched anew, in search distances. */
      constexpr double stale_after = 0.125;

      /** A penalty aims a little below the threshold that it has to keep. */
      constexpr double safety = 0.9;
    } // namespace



    FiberContact::FiberContact(const System::FiberSpace         &space,
                               const Contact::ContactParameters &parameters)
      : space(space)
      , parameters(parameters)
      , threshold(parameters.threshold)
      , filter([](unsigned int, unsigned int) { return true; })
    {
      for (unsigned int f = 0; f < space.n_fibers(); ++f)
        largest_radius = std::max(largest_radius, space.fiber(f).radius);
    }



    void
    FiberContact::restrict_to(const Filter &new_filter)
    {
      filter   = new_filter;
      searched = false;
    }



    void
    FiberContact::set_threshold(const double value)
    {
      threshold = value;
    }



    void
    FiberContact::begin_step(System::State &)
    {
      searched = false;
      pattern_pairs.clear();
    }



    void
    FiberContact::update(System::State &state)
    {
      update_curves(state);
      const double distance = parameters.search_distance * largest_radius;
      const double moved    = Utilities::MPI::max(
        searched ? moved_since_search(state) : distance, space.communicator());
      if (moved > stale_after * distance)
        search(state);
      place_elements();
      gather_statistics();
    }



    void
    FiberContact::probe(System::State &state)
    {
      update_curves(state);
      place_elements();
    }



    void
    FiberContact::update_curves(const System::State &state)
    {
      first_knot.assign(space.n_fibers(), 0);
      unsigned int n_knots = 0;
      for (unsigned int f = 0; f < space.n_fibers(); ++f)
        if (state.has(f))
          {
            first_knot[f] = n_knots;
            n_knots += space.fiber(f).n_nodes;
          }
      knot_positions.resize(n_knots);
      knot_tangents.resize(n_knots);
      for (unsigned int f = 0; f < space.n_fibers(); ++f)
        if (state.has(f))
          space.centerline_knots(f,
                                 state.fiber(f),
                                 knot_positions.data() + first_knot[f],
                                 knot_tangents.data() + first_knot[f]);
    }



    Contact::Curve
    FiberContact::curve(const unsigned int f) const
    {
      return Contact::Curve(space.fiber(f).n_nodes,
                            space.node_positions(f),
                            knot_positions.data() + first_knot[f],
                            knot_tangents.data() + first_knot[f],
                            space.fiber(f).radius);
    }



    Contact::IntermediateGeometry
    FiberContact::geometry(const Contact::ContactCell &cell) const
    {
      const Contact::Curve a = curve(cell.fiber_a);
      return Contact::IntermediateGeometry(
        a,
        curve(cell.fiber_b),
        cell.orientation,
        cell.fiber_a == cell.fiber_b ? Contact::least_self_separation(a) : 0.);
    }



    double
    FiberContact::moved_since_search(const System::State &state) const
    {
      // The control points of the cubics bound the motion of the axis.
      double largest = 0.;
      for (unsigned int f = 0; f < space.n_fibers(); ++f)
        if (state.has(f))
          {
            const double third =
              space.fiber(f).length / (3. * (space.fiber(f).n_nodes - 1));
            for (unsigned int i = first_knot[f];
                 i < first_knot[f] + space.fiber(f).n_nodes;
                 ++i)
              {
                const Tensor<1, 3> position =
                  knot_positions[i] - searched_at[2 * i];
                const Tensor<1, 3> tangent =
                  third * (knot_tangents[i] - searched_at[2 * i + 1]);
                largest = std::max({largest,
                                    (position + tangent).norm(),
                                    (position - tangent).norm()});
              }
          }
      return largest;
    }



    void
    FiberContact::fetch_near_fibers(System::State &state)
    {
      // Boxes of whole fibers, from all ranks, say which may come near.
      const double margin =
        largest_radius * (1. + 0.5 * parameters.search_distance);
      std::vector<double> boxes(6 * space.n_fibers(),
                                -std::numeric_limits<double>::max());
      const auto          owned = space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        for (unsigned int i = 0; i < space.fiber(f).n_nodes; ++i)
          {
            const double third =
              space.fiber(f).length / (3. * (space.fiber(f).n_nodes - 1));
            const unsigned int k = first_knot[f] + i;
            for (const double side : {-third, 0., third})
              for (unsigned int d = 0; d < 3; ++d)
                {
                  const double x =
                    knot_positions[k][d] + side * knot_tangents[k][d];
                  boxes[6 * f + d] = std::max(boxes[6 * f + d], x + margin);
                  boxes[6 * f + 3 + d] =
                    std::max(boxes[6 * f + 3 + d], margin - x);
                }
          }
      std::vector<double> all_boxes(boxes.size());
      Utilities::MPI::max(boxes, space.communicator(), all_boxes);

      std::vector<unsigned int> near;
      for (unsigned int f = 0; f < space.n_fibers(); ++f)
        if (!space.owns(f))
          for (unsigned int g = owned.first; g < owned.second; ++g)
            {
              bool meet = true;
              for (unsigned int d = 0; d < 3 && meet; ++d)
                meet = all_boxes[6 * f + d] + all_boxes[6 * g + 3 + d] > 0. &&
                       all_boxes[6 * g + d] + all_boxes[6 * f + 3 + d] > 0.;
              if (meet)
                {
                  near.push_back(f);
                  break;
                }
            }
      const bool changed =
        Utilities::MPI::max(near != state.ghost_fibers() ? 1 : 0,
                            space.communicator()) > 0;
      if (changed)
        {
          state.set_ghost_fibers(near);
          pattern_pairs.clear();
        }
    }



    double
    FiberContact::whole_cell(const unsigned int a, const unsigned int b) const
    {
      const auto interval = [this](const unsigned int f) {
        return space.fiber(f).length / (space.fiber(f).n_nodes - 1);
      };
      // p is twice an arc length.
      return (interval(a) + interval(b)) / parameters.refinement;
    }



    std::pair<double, double>
    FiberContact::range(const Contact::ContactCell          &cell,
                        const Contact::IntermediateGeometry &between) const
    {
      const double size =
        std::ldexp(whole_cell(cell.fiber_a, cell.fiber_b), -int(cell.level));
      const auto whole = between.range();
      return {std::max(cell.number * size, whole.first),
              std::min((cell.number + 1) * size, whole.second)};
    }



    double
    FiberContact::first_penalty(const unsigned int a,
                                const unsigned int b) const
    {
      // Hertz, parallel cylinders: p = pi/4 E* d with E* = E/2 for equal ones.
      const auto modulus = [this](const unsigned int f) {
        const System::Fiber &fiber = space.fiber(f);
        return fiber.section.axial /
               (numbers::PI * fiber.radius * fiber.radius);
      };
      return numbers::PI / 4. / (1. / modulus(a) + 1. / modulus(b));
    }



    void
    FiberContact::search(System::State &state)
    {
      fetch_near_fibers(state);
      update_curves(state);
      searched_at.resize(2 * knot_positions.size());
      for (unsigned int i = 0; i < knot_positions.size(); ++i)
        {
          searched_at[2 * i]     = knot_positions[i];
          searched_at[2 * i + 1] = knot_tangents[i];
        }

      std::vector<Contact::NumberedCurve> curves;
      for (unsigned int f = 0; f < space.n_fibers(); ++f)
        if (state.has(f))
          curves.push_back({f, space.owns(f), curve(f)});
      const std::vector<Contact::CandidatePair> candidates =
        Contact::find_candidates(curves,
                                 parameters.search_distance * largest_radius);

      std::vector<Contact::ContactCell> old_cells;
      old_cells.swap(cells);
      zones.clear();
      for (auto first = candidates.begin(); first != candidates.end();)
        {
          auto last = first;
          while (last != candidates.end() && last->fiber_a == first->fiber_a &&
                 last->fiber_b == first->fiber_b)
            ++last;
          if (filter(first->fiber_a, first->fiber_b))
            {
              const Contact::Curve a = curve(first->fiber_a),
                                   b = curve(first->fiber_b);
              for (const Contact::ProximityZone &zone :
                   Contact::find_zones(&*first, &*first + (last - first), a, b))
                cover_zone(zone, a, b, old_cells);
            }
          first = last;
        }
      std::sort(cells.begin(), cells.end());
      searched = true;
    }



    void
    FiberContact::cover_zone(const Contact::ProximityZone            &zone,
                             const Contact::Curve                    &a,
                             const Contact::Curve                    &b,
                             const std::vector<Contact::ContactCell> &old_cells)
    {
      Contact::ContactCell cell                   = {};
      cell.fiber_a                                = zone.fiber_a;
      cell.fiber_b                                = zone.fiber_b;
      cell.orientation                            = zone.orientation;
      cell.zone                                   = zones.size();
      const Contact::IntermediateGeometry between = geometry(cell);

      // Across one cell the fibers part by no more than about a radius.
      const double whole  = whole_cell(zone.fiber_a, zone.fiber_b);
      const double radius = std::min(a.radius, b.radius);
      while (std::ldexp(0.5 * whole * zone.sine, -int(cell.level)) > radius)
        ++cell.level;
      const double size = std::ldexp(whole, -int(cell.level));

      const double begin = std::max(zone.begin, between.range().first);
      const double end   = std::min(zone.end, between.range().second);
      if (begin >= end)
        return;
      zones.push_back({0., radius});

      // Along p the distance changes by at most sin(45 deg), but past the end
      // of a fiber as much as p.
      const double reach = a.radius + b.radius +
                           parameters.search_distance * largest_radius +
                           0.5 * size;
      const auto first_of_zone = cells.size();
      double     known_penalty = 0.;
      for (cell.number = std::floor(begin / size); cell.number * size < end;
           ++cell.number)
        {
          const auto   p      = range(cell, between);
          const double middle = 0.5 * (p.first + p.second);
          double       q      = zone.guess(middle);
          if (between.facing(middle, q).squared_distance > reach * reach)
            continue;
          cell.q_begin = cell.q_end = q;
          between.facing(p.first, cell.q_begin);
          between.facing(p.second, cell.q_end);

          // Two zones of one pair may end in one cell: it belongs to the first.
          const auto same = [&cell, size](const Contact::ContactCell &other) {
            return other.number == cell.number && other.level == cell.level &&
                   other.orientation == cell.orientation &&
                   std::abs(other.q_begin - cell.q_begin) < size;
          };
          bool known = false;
          for (auto k = first_of_zone;
               k > 0 && cells[k - 1].fiber_a == cell.fiber_a &&
               cells[k - 1].fiber_b == cell.fiber_b && !known;
               --k)
            known = same(cells[k - 1]);
          if (known)
            continue;

          cell.penalty  = old_penalty(cell, old_cells);
          known_penalty = std::max(known_penalty, cell.penalty);
          cells.push_back(cell);
        }

      // A zone that grew is as stiff in its new cells as in its old ones.
      if (known_penalty == 0.)
        known_penalty = first_penalty(zone.fiber_a, zone.fiber_b);
      for (auto k = first_of_zone; k < cells.size(); ++k)
        if (cells[k].penalty == 0.)
          cells[k].penalty = known_penalty;
    }



    double
    FiberContact::old_penalty(
      const Contact::ContactCell              &cell,
      const std::vector<Contact::ContactCell> &old_cells) const
    {
      // The cell itself, or one of another level that covers its middle.
      Contact::ContactCell low = cell;
      low.orientation          = -2;
      const double whole       = whole_cell(cell.fiber_a, cell.fiber_b);
      const double middle =
        std::ldexp((cell.number + 0.5) * whole, -int(cell.level));
      double penalty = 0.;
      for (auto old = std::lower_bound(old_cells.begin(), old_cells.end(), low);
           old != old_cells.end() && old->fiber_a == cell.fiber_a &&
           old->fiber_b == cell.fiber_b;
           ++old)
        {
          const double size = std::ldexp(whole, -int(old->level));
          if (old->orientation == cell.orientation &&
              std::abs((old->number + 0.5) * size - middle) < 0.51 * size &&
              std::abs(old->q_begin - cell.q_begin) < whole)
            penalty = std::max(penalty, old->penalty);
        }
      return penalty;
    }



    void
    FiberContact::place_elements()
    {
      contact_elements.clear();
      for (Zone &zone : zones)
        zone.penetration = 0.;

      Contact::CellEnd end = {};
      for (unsigned int c = 0; c < cells.size(); ++c)
        {
          const Contact::ContactCell         &cell    = cells[c];
          const Contact::IntermediateGeometry between = geometry(cell);
          const auto                          p       = range(cell, between);

          // Neighbouring cells share their ends.
          const bool continues = c > 0 && cells[c - 1].zone == cell.zone &&
                                 cells[c - 1].number + 1 == cell.number;
          const Contact::CellEnd begin =
            continues ? end : Contact::cell_end(between, p.first, cell.q_begin);
          end = Contact::cell_end(between, p.second, cell.q_end);

          const auto   first = contact_elements.size();
          const double penetration =
            Contact::place_elements(between, begin, end, contact_elements);
          Zone &zone       = zones[cell.zone];
          zone.penetration = std::max(zone.penetration, penetration);
          for (auto k = first; k < contact_elements.size(); ++k)
            {
              Contact::ContactElement &element = contact_elements[k];
              element.fiber_a                  = cell.fiber_a;
              element.fiber_b                  = cell.fiber_b;
              element.zone                     = cell.zone;
              element.penalty                  = cell.penalty;
              element.force =
                element.gap < 0.
                  ? element.weight *
                      law(zone.radius).pressure(cell.penalty, -element.gap)
                  : 0.;
            }
        }
    }



    void
    FiberContact::gather_statistics()
    {
      std::array<double, 4> sums     = {};
      std::array<double, 3> extremes = {{0., 0., -1e300}};
      for (const Contact::ContactElement &element : contact_elements)
        if (space.owns(element.fiber_a) && element.force > 0.)
          {
            sums[0] += 1.;
            sums[1] += element.force;
            sums[2] +=
              element.weight * law(zones[element.zone].radius)
                                 .energy(element.penalty, -element.gap);
            extremes[1] = std::max(extremes[1], element.penalty);
            extremes[2] = std::max(extremes[2], -element.penalty);
          }
      // Where the surfaces do not overlap, a cell stands for its two elements.
      for (const Contact::ContactCell &cell : cells)
        sums[3] += space.owns(cell.fiber_a) ? 2. : 0.;
      for (const Zone &zone : zones)
        extremes[0] = std::max(extremes[0], zone.penetration / zone.radius);
      sum_over_ranks(sums, space.communicator());
      max_over_ranks(extremes, space.communicator());

      statistics.n_active        = sums[0];
      statistics.n_elements      = std::max(sums[3], sums[0]);
      statistics.mean_force      = sums[0] > 0. ? sums[1] / sums[0] : 0.;
      statistics.energy          = sums[2];
      statistics.deepest         = extremes[0];
      statistics.largest_penalty = extremes[1];
      statistics.least_penalty   = sums[0] > 0. ? -extremes[2] : 0.;
    }



    std::vector<Contact::CandidatePair>
    FiberContact::active_pairs() const
    {
      std::vector<Contact::CandidatePair> pairs;
      for (const Contact::ContactElement &element : contact_elements)
        if (element.force > 0.)
          pairs.push_back({element.fiber_a,
                           element.fiber_b,
                           space.interval(element.fiber_a, element.s_a),
                           space.interval(element.fiber_b, element.s_b)});
      std::sort(pairs.begin(), pairs.end());
      return pairs;
    }



    bool
    FiberContact::needs_new_pattern() const
    {
      const std::vector<Contact::CandidatePair> pairs = active_pairs();
      return !std::includes(
        pattern_pairs.begin(), pattern_pairs.end(), pairs.begin(), pairs.end());
    }



    void
    FiberContact::locate(const System::State           &state,
                         const Contact::ContactElement &element,
                         unsigned int                  *blocks,
                         double                        *weights) const
    {
      const System::MaterialPoint a =
        space.locate(element.fiber_a, element.s_a);
      const System::MaterialPoint b =
        space.locate(element.fiber_b, element.s_b);
      for (unsigned int i = 0; i < 4; ++i)
        {
          blocks[i]      = state.local_block(element.fiber_a) + a.blocks[i];
          blocks[4 + i]  = state.local_block(element.fiber_b) + b.blocks[i];
          weights[i]     = a.values[i];
          weights[4 + i] = -b.values[i];
        }
    }



    void
    FiberContact::add_pattern(const System::State          &state,
                              System::BlockSystem::Pattern &pattern)
    {
      pattern_pairs = active_pairs();
      pattern_pairs.erase(std::unique(pattern_pairs.begin(),
                                      pattern_pairs.end(),
                                      [](const auto &left, const auto &right) {
                                        return !(left < right) &&
                                               !(right < left);
                                      }),
                          pattern_pairs.end());

      unsigned int blocks[8];
      double       weights[8];
      for (const Contact::CandidatePair &pair : pattern_pairs)
        {
          Contact::ContactElement element = {};
          element.fiber_a                 = pair.fiber_a;
          element.fiber_b                 = pair.fiber_b;
          const double *s_a               = space.node_positions(pair.fiber_a);
          const double *s_b               = space.node_positions(pair.fiber_b);
          element.s_a = 0.5 * (s_a[pair.interval_a] + s_a[pair.interval_a + 1]);
          element.s_b = 0.5 * (s_b[pair.interval_b] + s_b[pair.interval_b + 1]);
          locate(state, element, blocks, weights);
          pattern.couple(8, blocks);
        }
    }



    void
    FiberContact::assemble(const System::State &state,
                           System::BlockSystem &system)
    {
      unsigned int            blocks[8];
      double                  weights[8];
      std::array<double, 24>  direction, residual;
      std::array<double, 576> tangent;
      for (const Contact::ContactElement &element : contact_elements)
        if (element.force > 0.)
          {
            locate(state, element, blocks, weights);

            // The gap changes by direction . motion, the energy by -force.
            for (unsigned int i = 0; i < 8; ++i)
              for (unsigned int d = 0; d < 3; ++d)
                {
                  direction[3 * i + d] = weights[i] * element.normal[d];
                  residual[3 * i + d]  = -element.force * direction[3 * i + d];
                }
            if (system.wants_tangent())
              {
                const double stiffness =
                  element.weight * law(zones[element.zone].radius)
                                     .stiffness(element.penalty, -element.gap);
                for (unsigned int i = 0; i < 24; ++i)
                  for (unsigned int j = 0; j < 24; ++j)
                    tangent[24 * i + j] =
                      stiffness * direction[i] * direction[j];
              }
            system.add(8, blocks, residual.data(), tangent.data());
          }
    }



    std::pair<double, double>
    FiberContact::slope_and_curvature(const System::State     &state,
                                      const System::Increment &increment) const
    {
      unsigned int blocks[8];
      double       weights[8];
      double       slope = 0., curvature = 0.;
      for (const Contact::ContactElement &element : contact_elements)
        if (element.force > 0. && space.owns(element.fiber_a))
          {
            locate(state, element, blocks, weights);
            double opening = 0.;
            for (unsigned int i = 0; i < 8; ++i)
              opening += weights[i] * (element.normal * increment[blocks[i]]);
            slope -= element.force * opening;
            curvature += element.weight *
                         law(zones[element.zone].radius)
                           .stiffness(element.penalty, -element.gap) *
                         opening * opening;
          }
      return {slope, curvature};
    }



    double
    FiberContact::largest_step(const System::State     &state,
                               const System::Increment &increment) const
    {
      // Nothing may leave the range within which all pairs are known.
      double                    largest = 0.;
      std::vector<Tensor<1, 3>> positions, tangents;
      const auto                owned = space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        {
          positions.resize(space.fiber(f).n_nodes);
          tangents.resize(space.fiber(f).n_nodes);
          space.centerline_knots(f,
                                 increment.data() + state.local_block(f),
                                 positions.data(),
                                 tangents.data());
          const double third =
            space.fiber(f).length / (3. * (space.fiber(f).n_nodes - 1));
          for (unsigned int i = 0; i < positions.size(); ++i)
            largest = std::max({largest,
                                (positions[i] + third * tangents[i]).norm(),
                                (positions[i] - third * tangents[i]).norm()});
        }
      const double allowed =
        (0.5 - stale_after) * parameters.search_distance * largest_radius;
      return largest > allowed ? allowed / largest : 1.;
    }



    bool
    FiberContact::adapt(const System::State &)
    {
      bool changed = false;
      for (Contact::ContactCell &cell : cells)
        {
          const Zone  &zone  = zones[cell.zone];
          const double ratio = zone.penetration / (threshold * zone.radius);
          if (ratio > 1. || (ratio > 0. && ratio < 0.3))
            {
              cell.penalty *= std::min(std::max(ratio / safety, 0.5), 4.);
              changed = true;
            }
        }
      return Utilities::MPI::max(changed ? 1 : 0, space.communicator()) > 0;
    }
  } // namespace Contributions
} // namespace Heddle
