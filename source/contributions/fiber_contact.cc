#include <heddle/base/reduce.h>
#include <heddle/contact/geometric_stiffness.h>
#include <heddle/contributions/centerlines.h>
#include <heddle/contributions/fiber_contact.h>
#include <heddle/contributions/interval_pairs.h>
#include <heddle/contributions/summed_terms.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Heddle
{
  namespace Contributions
  {
    namespace
    {
      /**
       * Thickness of the softest skin, in radii. A thicker one swells the yarns
       * and lets them repack when it goes: more iterations, not fewer.
       */
      constexpr double thickest_skin = 0.05;

      /**
       * First penalty over the stiffness of what yields beside it: penalties
       * that begin too high hold fibers where they happened to meet.
       */
      constexpr double first_softness = 0.2;

      /**
       * Surfaces so close to each other, in radii, have their places in the
       * tangent: contacts come and go, and a new pattern takes as long as some
       * iterations of the linear solver.
       */
      constexpr double pattern_margin = 0.1;

      /** What is left after so many is round-off. */
      constexpr unsigned int most_turns_to_forgive = 50;

      /** No guess is followed that lays fibers so deep in each other, in radii.
       */
      constexpr double deepest_guess = 0.3;

      /** ... or that loses more than this part of the contacts. */
      constexpr double largest_loss = 0.9;

      /**
       * Fibers that sink deeper into each other than this, in radii, are on
       * their way through each other: at 2 their axes meet. Penalties grow at
       * once then, and not when the iteration is calm, as long as they sink
       * deeper by this factor. Where a solution begins they may be as deep.
       */
      constexpr double deepest_without_help = 1., deeper = 1.02;



      double
      find_largest_radius(const System::FiberSpace &space)
      {
        double largest = 0.;
        for (unsigned int f = 0; f < space.n_fibers(); ++f)
          largest = std::max(largest, space.fiber(f).radius);
        return largest;
      }
    } // namespace



    FiberContact::FiberContact(const System::FiberSpace         &space,
                               const Contact::ContactParameters &parameters)
      : space(space)
      , refinement(parameters.refinement)
      , threshold(parameters.threshold)
      , largest_radius(find_largest_radius(space))
      , filter([](unsigned int, unsigned int) { return true; })
      , fibers(space, largest_radius, parameters.search_distance)
      , cells(parameters.search_distance * largest_radius,
              parameters.refinement,
              [this](const unsigned int a, const unsigned int b) {
                return first_penalty(a, b);
              })
    {
    }



    void
    FiberContact::restrict_to(const Contact::ContactCells::Filter &new_filter)
    {
      filter = new_filter;
      fibers.forget_search();
    }



    void
    FiberContact::set_threshold(const double value)
    {
      threshold = value;
      placed    = false;
    }



    void
    FiberContact::forgive_penetration(System::State &state)
    {
      begin_step(state);
      softness = 0.;
      update(state);

      // Elements of crossings move as surfaces do, and may find a little more.
      for (unsigned int turn = 0;
           turn < most_turns_to_forgive && statistics.n_active > 0.;
           ++turn)
        {
          cells.forgive();
          placed = false;
          update(state);
        }
      hardening = 0.;
      cells.accept();
      accepted_cells  = cells.cells();
      accepted_active = 0.;
      accepted_forces.clear();
    }



    void
    FiberContact::forget()
    {
      cells.set_cells({});
      cells.set_forgiven({});
      accepted_cells.clear();
      accepted_forces.clear();
      accepted_active = hardening = 0.;
      fibers.forget_search();
    }



    void
    FiberContact::begin_step(System::State &)
    {
      fibers.forget_search();
      deepest_before = std::numeric_limits<double>::max();
      pattern_pairs.clear();
    }



    void
    FiberContact::update(System::State &state)
    {
      fibers.set(state);
      if (fibers.needs_search(state))
        search(state);
      place_elements(state);
      gather_statistics();
    }



    void
    FiberContact::begin_iteration(System::State &state)
    {
      if (statistics.deepest > deepest_without_help &&
          statistics.deepest > deeper * deepest_before)
        {
          cells.adapt(deepest_guess);
          placed = false;
          place_elements(state);
          gather_statistics();
        }
      deepest_before = statistics.deepest;
    }



    void
    FiberContact::update_trial(System::State &state)
    {
      fibers.set(state);
      fibers.measure_motion(state);
      place_elements(state);
    }



    void
    FiberContact::search(System::State &state)
    {
      if (fibers.begin_search(state))
        pattern_pairs.clear();
      cells.search(fibers.curves(), fibers.moved(), filter);
      placed = false;

      thickness.assign(space.n_fibers(), std::numeric_limits<double>::max());
      for (const Contact::ContactCell &cell : cells.cells())
        {
          const double sum =
            space.fiber(cell.fiber_a).radius + space.fiber(cell.fiber_b).radius;
          for (const unsigned int f : {cell.fiber_a, cell.fiber_b})
            thickness[f] = std::min(thickness[f], sum);
        }
    }



    double
    FiberContact::first_penalty(const unsigned int a,
                                const unsigned int b) const
    {
      // What yields along the normal, in series: the sections, as in Hertz'
      // line contact of cylinders, p = pi/4 E d, and the axis, which bends
      // between its nodes, p = E I (2 pi / h)^4 d.
      const auto compliance = [this](const unsigned int f) {
        const System::Fiber &fiber = space.fiber(f);
        const double         modulus =
          fiber.section.axial / (numbers::PI * fiber.radius * fiber.radius);
        const double wave_number =
          2. * numbers::PI * (fiber.n_nodes - 1) / fiber.length;
        return 4. / (numbers::PI * modulus) +
               1. / (fiber.section.bending * std::pow(wave_number, 4.));
      };
      return first_softness / (compliance(a) + compliance(b));
    }



    void
    FiberContact::place_elements(const System::State &state)
    {
      // The line search often ends where it looked last.
      if (placed && placed_at == state.current())
        return;
      contact_elements.clear();
      cells.place_elements(fibers.curves(),
                           fibers.moved(),
                           threshold,
                           softness * thickest_skin,
                           contact_elements);
      placed    = true;
      placed_at = state.current();
      ++n_placements;
    }



    double
    FiberContact::penetration(const Contact::ContactElement &element) const
    {
      // At its ends a stretch of overlap may miss contact by a little.
      return std::max(-element.gap, -law(element).skin);
    }



    Contact::NormalLaw
    FiberContact::law(const Contact::ContactElement &element) const
    {
      return cells.law(element.zone, threshold, softness * thickest_skin);
    }



    double
    FiberContact::stiffness(const Contact::ContactElement &element) const
    {
      return element.weight *
             law(element).stiffness(element.penalty, penetration(element));
    }



    SymmetricTensor<2, 3>
    FiberContact::tangent(const Contact::ContactElement &element) const
    {
      const SymmetricTensor<2, 3> normal =
        stiffness(element) *
        symmetrize(outer_product(element.normal, element.normal));
      if (!forces_turn)
        return normal;
      const double distance = space.fiber(element.fiber_a).radius +
                              space.fiber(element.fiber_b).radius -
                              element.forgiven + element.gap;
      return normal +
             Contact::geometric_stiffness(fibers.curves()[element.fiber_a],
                                          fibers.curves()[element.fiber_b],
                                          element,
                                          distance);
    }



    void
    FiberContact::gather_statistics()
    {
      struct
      {
        double n_active = 0., n_watched = 0., force = 0., energy = 0.;
      } sums;
      struct
      {
        double relative_penetration = 0., penalty = 0.,
               negative_penalty = -1e300;
      } largest;
      // The elements of a cell follow each other: together they are one
      // contact.
      unsigned int last_cell = numbers::invalid_unsigned_int;
      for (const Contact::ContactElement &element : contact_elements)
        if (space.owns(element.fiber_a))
          {
            sums.n_active += element.cell != last_cell ? 1. : 0.;
            last_cell = element.cell;
            sums.force += element.force;
            sums.energy += energy(element);
            largest.penalty = std::max(largest.penalty, element.penalty);
            largest.negative_penalty =
              std::max(largest.negative_penalty, -element.penalty);
          }
      for (const Contact::ContactCell &cell : cells.cells())
        sums.n_watched += space.owns(cell.fiber_a) ? 1. : 0.;
      for (const Contact::ContactCells::Zone &zone : cells.zones())
        largest.relative_penetration = std::max(largest.relative_penetration,
                                                zone.penetration / zone.radius);
      sum_over_ranks(sums, space.communicator());
      max_over_ranks(largest, space.communicator());

      statistics.n_active  = sums.n_active;
      statistics.n_watched = sums.n_watched;
      statistics.mean_force =
        sums.n_active > 0. ? sums.force / sums.n_active : 0.;
      statistics.energy          = sums.energy;
      statistics.deepest         = largest.relative_penetration;
      statistics.largest_penalty = largest.penalty;
      statistics.least_penalty =
        sums.n_active > 0. ? -largest.negative_penalty : 0.;
    }



    bool
    FiberContact::needs_new_pattern() const
    {
      if (pattern_covers_all)
        return false;
      const std::vector<Contact::CandidatePair> pairs =
        interval_pairs(space, contact_elements);
      return !std::includes(
        pattern_pairs.begin(), pattern_pairs.end(), pairs.begin(), pairs.end());
    }



    void
    FiberContact::locate(const System::State            &state,
                         const Contact::ContactElement  &element,
                         System::AxisCouplings::Blocks  &blocks,
                         System::AxisCouplings::Weights &weights) const
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
    FiberContact::add_pattern(const System::State  &state,
                              System::BlockPattern &pattern)
    {
      pattern_covers_all = pattern.couplings_apart;
      if (pattern_covers_all)
        {
          const auto owned = space.owned_fibers();
          for (unsigned int f = owned.first; f < owned.second; ++f)
            for (unsigned int i = 0; i + 1 < space.fiber(f).n_nodes; ++i)
              pattern.couple(4, locate_middles(state, {f, f, i, i}).data());
          return;
        }

      pattern_pairs = union_of(
        cells.near_pairs(fibers.curves(), pattern_margin * largest_radius),
        interval_pairs(space, contact_elements));
      for (const Contact::CandidatePair &pair : pattern_pairs)
        pattern.couple(8, locate_middles(state, pair).data());
    }



    System::AxisCouplings::Blocks
    FiberContact::locate_middles(const System::State          &state,
                                 const Contact::CandidatePair &pair) const
    {
      System::AxisCouplings::Blocks  blocks;
      System::AxisCouplings::Weights weights;
      locate(state, contact_of_middles(space, pair), blocks, weights);
      return blocks;
    }



    void
    FiberContact::assemble(const System::State &state,
                           System::BlockSystem &system)
    {
      System::AxisCouplings::Blocks blocks;
      System::AxisCouplings::Term   term;
      SummedTerms of_pairs(system), of_a(system), of_b(system);
      if (system.wants_tangent() && system.keeps_couplings_apart())
        system.axis_couplings().reserve(
          std::count_if(contact_elements.begin(),
                        contact_elements.end(),
                        [](const Contact::ContactElement &element) {
                          return element.force > 0.;
                        }));
      for (const Contact::ContactElement &element : contact_elements)
        if (element.force > 0.)
          {
            // The gap changes by normal . motion, the energy by -force.
            const Tensor<1, 3> force = -element.force * element.normal;
            locate(state, element, blocks, term.weights);
            if (system.wants_tangent())
              term.stiffness = tangent(element);
            if (system.keeps_couplings_apart())
              {
                add_side_by_side<4>(blocks, term, force, of_a, of_b);
                if (system.wants_tangent())
                  system.axis_couplings().add_term(blocks, term);
                continue;
              }

            of_pairs.begin(8, blocks.data());
            for (unsigned int i = 0; i < 8; ++i)
              for (unsigned int d = 0; d < 3; ++d)
                of_pairs.residual()[3 * i + d] += term.weights[i] * force[d];
            if (system.wants_tangent())
              {
                double                               *sum = of_pairs.tangent();
                std::array<std::array<double, 24>, 3> rows;
                for (unsigned int d = 0; d < 3; ++d)
                  for (unsigned int e = 0; e < 3; ++e)
                    for (unsigned int j = 0; j < 8; ++j)
                      rows[d][3 * j + e] =
                        term.weights[j] * term.stiffness[d][e];
                for (unsigned int i = 0; i < 8; ++i)
                  for (const auto &row : rows)
                    for (const double value : row)
                      *sum++ += term.weights[i] * value;
              }
          }
      for (SummedTerms *terms : {&of_pairs, &of_a, &of_b})
        terms->end();
    }



    std::pair<double, double>
    FiberContact::slope_and_curvature(const System::State     &state,
                                      const System::Increment &increment) const
    {
      Centerlines motion(space);
      motion.set(state, increment);
      double slope = 0., curvature = 0.;
      for (const Contact::ContactElement &element : contact_elements)
        if (element.force > 0. && space.owns(element.fiber_a))
          {
            const Tensor<1, 3> apart =
              motion.curve(element.fiber_a).at(element.s_a) -
              motion.curve(element.fiber_b).at(element.s_b);
            slope -= element.force * (element.normal * apart);
            curvature += apart * (tangent(element) * apart);
          }
      return {slope, curvature};
    }



    bool
    FiberContact::is_credible() const
    {
      return statistics.deepest < deepest_guess &&
             statistics.n_active >= (1. - largest_loss) * accepted_active;
    }



    bool
    FiberContact::adapt(const System::State &)
    {
      const double allowed = std::max(threshold, softness * thickest_skin);
      if (statistics.deepest <= allowed)
        return false;
      const bool changed =
        Utilities::MPI::logical_or(cells.adapt(allowed), space.communicator());
      placed = placed && !changed;
      return changed;
    }



    double
    FiberContact::energy(const Contact::ContactElement &element) const
    {
      return element.weight *
             law(element).energy(element.penalty, penetration(element));
    }



    double
    FiberContact::energy_of_hardening()
    {
      // From its force F_0 and penalty k_0 to F_1 and k_1 a pair is worked on
      // by (F_0 + F_1)/2 (F_1/k_1 - F_0/k_0), as trapezoids count it. What its
      // energy F^2/2k grows by beyond that is F_0 F_1 (1/k_0 - 1/k_1)/2: the
      // energy at the end times (k_1/k_0 - 1) F_0/F_1.
      double             sum = 0.;
      std::vector<Force> forces;
      auto               before = accepted_forces.begin();
      for (auto element = contact_elements.begin();
           element != contact_elements.end();)
        {
          Force  now     = {{element->fiber_a, element->fiber_b}, 0.};
          double brought = 0.;
          for (; element != contact_elements.end() &&
                 element->fiber_a == now.first.first &&
                 element->fiber_b == now.first.second;
               ++element)
            {
              now.second += element->force;
              brought +=
                energy(*element) * (cells.cells()[element->cell].hardened - 1.);
            }
          while (before != accepted_forces.end() && before->first < now.first)
            ++before;
          if (now.second == 0. || !space.owns(now.first.first))
            continue;
          if (before != accepted_forces.end() && before->first == now.first)
            sum += brought * before->second / now.second;
          forces.push_back(now);
        }
      accepted_forces = forces;
      return Utilities::MPI::sum(sum, space.communicator());
    }



    void
    FiberContact::accept_step(const System::State &)
    {
      hardening += energy_of_hardening();
      cells.accept();
      accepted_cells  = cells.cells();
      accepted_active = statistics.n_active;
      indented =
        find_indentation(space, fibers.curves(), contact_elements, threshold);
      largest_mean_force = std::max(largest_mean_force, statistics.mean_force);
    }



    void
    FiberContact::reject_step(System::State &)
    {
      cells.set_cells(accepted_cells);
      fibers.forget_search();
      softness = 0.;
      placed   = false;
    }
  } // namespace Contributions
} // namespace Heddle
