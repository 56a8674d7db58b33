#include <heddle/base/reduce.h>
#include <heddle/contributions/fiber_friction.h>
#include <heddle/contributions/interval_pairs.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <map>

namespace Heddle
{
  namespace Contributions
  {
    FiberFriction::FiberFriction(const System::FiberSpace         &space,
                                 const Contact::ContactParameters &parameters,
                                 const FiberContact               &contact)
      : space(space)
      , parameters(parameters)
      , contact(contact)
      , coefficients(space, parameters)
    {
    }



    void
    FiberFriction::update(System::State &state)
    {
      if (ghost_version != state.ghost_version())
        pattern_pairs.clear();
      ghost_version = state.ghost_version();
      place_elements(state);
    }



    void
    FiberFriction::update_trial(System::State &state)
    {
      place_elements(state);
    }



    void
    FiberFriction::place_elements(const System::State &state)
    {
      // Contact places its elements anew wherever fibers have moved.
      if (placement == contact.placement())
        return;
      placement = contact.placement();
      elements.clear();
      if (!active)
        return;
      const auto touches = [](const Contact::ContactElement &touching) {
        return touching.force > 0.;
      };
      elements.reserve(std::count_if(
        contact.elements().begin(), contact.elements().end(), touches));
      for (const Contact::ContactElement &touching : contact.elements())
        if (touches(touching))
          {
            // Some pairs of sets may have no friction.
            const Element element = make_element(state, touching);
            if (element.law.limit > 0.)
              elements.push_back(element);
          }
    }



    FiberFriction::Element
    FiberFriction::make_element(const System::State           &state,
                                const Contact::ContactElement &touching) const
    {
      Element      element(state, touching);
      const auto   motion = element.motion(state);
      const double radius = std::min(space.fiber(element.fiber_a).radius,
                                     space.fiber(element.fiber_b).radius);
      const double coefficient =
        motion.side_on *
        coefficients(element.fiber_a, element.fiber_b, motion.cosine);
      element.law = {coefficient * touching.force,
                     parameters.reversible_displacement * radius};
      if (coefficient == 0.)
        return element;

      element.limit_stiffness = coefficient * contact.stiffness(touching);

      const auto left       = memory.at(touching, 0.5 * radius);
      element.energy_before = element.law.energy_ratio(left.displacement);
      element.limit_before  = left.limit;
      element.set_displacement(motion,
                               share_of_step(touching, motion),
                               left.displacement,
                               left.orientation);
      return element;
    }



    double
    FiberFriction::share_of_step(const Contact::ContactElement &touching,
                                 const FrictionElement::Motion &motion) const
    {
      // Where nothing touched within this motion a gap closed since then, at a
      // steady rate: in this part of the step.
      const double gap = motion.gap_before + touching.forgiven;
      if (gap <= 0.)
        return 1.;
      const double closed =
        touching.gap < 0. ? touching.gap / (touching.gap - gap) : 0.;

      // No force may jump where another contact comes within the motion.
      const double touched =
        memory.touched(touching, motion.displacement.norm());
      return touched + (1. - touched) * closed;
    }



    bool
    FiberFriction::needs_new_pattern() const
    {
      if (pattern_covers_all)
        return false;
      const auto pairs = interval_pairs(space, elements);
      return !std::includes(
        pattern_pairs.begin(), pattern_pairs.end(), pairs.begin(), pairs.end());
    }



    void
    FiberFriction::add_pattern(const System::State  &state,
                               System::BlockPattern &pattern)
    {
      // Without sections the displacement follows from the tangents too, and
      // what couples the fibers is in the matrix.
      pattern_covers_all =
        pattern.couplings_apart && space.n_blocks_per_node() == 3;
      if (pattern_covers_all)
        {
          const auto owned = space.owned_fibers();
          for (unsigned int f = owned.first; f < owned.second; ++f)
            for (unsigned int i = 0; i + 1 < space.fiber(f).n_nodes; ++i)
              {
                const FrictionElement element(
                  state, contact_of_middles(space, {f, f, i, i}));
                pattern.couple(element.n_blocks / 2, element.blocks.data());
              }
          return;
        }

      // Not those that may come to touch as well, as for contact: with sections
      // the matrix would be half as large again.
      Contact::extend_pairs(pattern_pairs, interval_pairs(space, elements));
      for (const Contact::CandidatePair &pair : pattern_pairs)
        {
          const FrictionElement element(state, contact_of_middles(space, pair));
          pattern.couple(element.n_blocks, element.blocks.data());
        }
    }



    void
    FiberFriction::assemble(const System::State &state,
                            System::BlockSystem &system)
    {
      Assert(ghost_version == state.ghost_version(),
             ExcMessage("Elements have the numbers that blocks had before."));
      if (system.wants_tangent())
        reserve(system);
      SummedTerms of_pairs(system), of_a(system), of_b(system);
      for (const Element &element : elements)
        {
          const Response response =
            respond(state, element, system.wants_tangent());
          if (system.keeps_couplings_apart() && element.has_sections())
            add_apart(element, response, of_a, of_b, system);
          else
            add(element, response, of_pairs);
          if (system.wants_tangent() && element.limit_stiffness > 0.)
            add_change_of_limit(
              element, response.displacement, system.unsymmetric_terms());
        }
      for (SummedTerms *terms : {&of_pairs, &of_a, &of_b})
        terms->end();
    }



    void
    FiberFriction::reserve(System::BlockSystem &system) const
    {
      if (elements.empty())
        return;
      const bool sections = elements.front().has_sections();
      if (system.keeps_couplings_apart() && sections)
        system.section_couplings().reserve(elements.size());
      system.unsymmetric_terms().reserve(
        elements.size(),
        (sections ? 1 : 3) * elements.size(),
        ((sections ? 1 : 2) * elements.front().n_blocks +
         FrictionElement::n_axis_blocks) *
          elements.size());
    }



    FiberFriction::Response
    FiberFriction::respond(const System::State &state,
                           const Element       &element,
                           const bool           with_stiffness) const
    {
      Response response        = {};
      response.displacement    = element.displacement(state.current());
      const auto        &u     = response.displacement;
      const auto        &axes  = element.axes;
      const Tensor<1, 3> force = element.law.force(u);
      response.force           = {{force * axes[0], force * axes[1]}};
      if (with_stiffness)
        {
          // What slides before there is contact does not count.
          const Tensor<2, 3> k =
            element.share_of_slide() * element.law.stiffness(u, element.normal);
          response.along  = axes[0] * (k * axes[0]);
          response.mixed  = axes[0] * (k * axes[1]);
          response.across = axes[1] * (k * axes[1]);
        }
      return response;
    }



    void
    FiberFriction::add(const Element  &element,
                       const Response &response,
                       SummedTerms    &terms) const
    {
      terms.begin(element.n_blocks, element.blocks.data());
      const FrictionElement::Derivative by(element);
      const unsigned int                n = 3 * element.n_blocks;
      const auto &by_along = by.rows[0], &by_across = by.rows[1];
      for (unsigned int i = 0; i < n; ++i)
        terms.residual()[i] +=
          response.force[0] * by_along[i] + response.force[1] * by_across[i];
      if (!terms.wants_tangent())
        return;

      std::array<double, 3 * FrictionElement::max_blocks> f, g;
      for (unsigned int j = 0; j < n; ++j)
        {
          f[j] = response.along * by_along[j] + response.mixed * by_across[j];
          g[j] = response.mixed * by_along[j] + response.across * by_across[j];
        }
      for (unsigned int i = 0; i < n; ++i)
        {
          double *row = terms.tangent() + n * i;
          for (unsigned int j = 0; j < n; ++j)
            row[j] += by_along[i] * f[j] + by_across[i] * g[j];
        }
    }



    void
    FiberFriction::add_apart(const Element       &element,
                             const Response      &response,
                             SummedTerms         &of_a,
                             SummedTerms         &of_b,
                             System::BlockSystem &system) const
    {
      // The displacement follows from the separation of the particles alone.
      System::SectionCouplings::Term term;
      term.weights = element.separation_weights();
      if (system.wants_tangent())
        {
          const Tensor<1, 3> first  = element.force_by_separation({{1., 0.}}),
                             second = element.force_by_separation({{0., 1.}});
          for (unsigned int d = 0; d < 3; ++d)
            for (unsigned int e = d; e < 3; ++e)
              term.stiffness[d][e] =
                response.along * first[d] * first[e] +
                response.mixed * (first[d] * second[e] + second[d] * first[e]) +
                response.across * second[d] * second[e];
          system.section_couplings().add_term(element.blocks, term);
        }
      add_side_by_side<8>(element.blocks,
                          term,
                          element.force_by_separation(response.force),
                          of_a,
                          of_b);
    }



    void
    FiberFriction::add_change_of_limit(const Element            &element,
                                       const Tensor<1, 3>       &u,
                                       System::UnsymmetricTerms &terms) const
    {
      // The wider the gap, the less friction, in its direction.
      const Tensor<1, 3> less =
        -element.limit_stiffness * element.law.part_of_limit(u);
      const std::array<double, 2> components = {
        {less * element.axes[0], less * element.axes[1]}};
      const unsigned int n       = element.n_blocks;
      const auto        &blocks  = element.blocks;
      const auto        &weights = element.separation_weights();
      terms.begin_term(element.normal);
      for (unsigned int side = 0; side < 2; ++side)
        for (unsigned int i = 0; i < FrictionElement::n_axis_blocks / 2; ++i)
          {
            const unsigned int k = side * (n / 2) + i;
            terms.add_motion(blocks[k], weights[k]);
          }
      terms.begin_force(element.force_by_separation(components));
      for (unsigned int i = 0; i < n; ++i)
        terms.add_force(blocks[i], weights[i]);
      for (unsigned int side = 0; side < 2 && !element.has_sections(); ++side)
        {
          terms.begin_force(element.force_by_tangent(side, components));
          for (unsigned int i = side * (n / 2); i < (side + 1) * (n / 2); ++i)
            terms.add_force(blocks[i], element.tangent_weights()[i]);
        }
    }



    std::pair<double, double>
    FiberFriction::slope_and_curvature(const System::State     &state,
                                       const System::Increment &increment) const
    {
      double slope = 0., curvature = 0.;
      for (const Element &element : elements)
        if (space.owns(element.fiber_a))
          {
            const Tensor<1, 3> u      = element.displacement(state.current());
            const Tensor<1, 3> motion = element.slide(increment);
            slope += element.law.force(u) * motion;
            curvature += element.share_of_slide() * motion *
                         (element.law.stiffness(u, element.normal) * motion);
          }
      return {slope, curvature};
    }



    void
    FiberFriction::report(const System::State           &state,
                          std::map<std::string, double> &values) const
    {
      struct
      {
        double stored = 0., n_elements = 0., n_slipping = 0.;
      } sums;
      for (const Element &element : elements)
        if (space.owns(element.fiber_a))
          {
            const Tensor<1, 3> u = element.displacement(state.current());
            sums.stored += element.law.energy(element.law.elastic_part(u));
            sums.n_elements += 1.;
            sums.n_slipping += u.norm() > element.law.reversible ? 1. : 0.;
          }
      sum_over_ranks(sums, space.communicator());
      values["friction_stored[N*mm]"]     = sums.stored;
      values["friction_dissipated[N*mm]"] = dissipated;
      values["slipping_part[-]"] =
        sums.n_elements > 0. ? sums.n_slipping / sums.n_elements : 0.;
    }



    std::vector<Contact::TangentialForce>
    FiberFriction::tangential_forces(const System::State &state) const
    {
      const auto                           &touching = contact.elements();
      std::vector<Contact::TangentialForce> result(touching.size());
      // They are in the order of those, some of which have no friction.
      auto at = touching.begin();
      for (const Element &element : elements)
        {
          at =
            std::find_if(at, touching.end(), [&element](const auto &candidate) {
              return candidate.fiber_a == element.fiber_a &&
                     candidate.fiber_b == element.fiber_b &&
                     candidate.s_a == element.s_a &&
                     candidate.s_b == element.s_b;
            });
          AssertThrow(at != touching.end(),
                      ExcMessage("Contact was placed anew since then."));
          const Tensor<1, 3> u = element.displacement(state.current());
          // The energy grows with u, and the force on fiber a is against it.
          result[at - touching.begin()] = {-1. * element.law.force(u),
                                           element.law.part_of_limit(u).norm()};
          ++at;
        }
      return result;
    }



    std::vector<double>
    FiberFriction::limits_before() const
    {
      struct Sum
      {
        double now = 0., before = 0., had = 0.;
      };
      std::map<std::pair<unsigned int, unsigned int>, Sum> sums;
      for (const Element &element : elements)
        {
          Sum &sum = sums[{element.fiber_a, element.fiber_b}];
          sum.now += element.law.limit;
          sum.before += element.limit_before;
        }
      for (auto &[fibers, sum] : sums)
        sum.had = memory.limit(fibers.first, fibers.second);

      std::vector<double> limits;
      for (const Element &element : elements)
        {
          const Sum   &sum    = sums.at({element.fiber_a, element.fiber_b});
          const double before = element.limit_before;
          limits.push_back(sum.before > sum.had
                             ? before * sum.had / sum.before
                             : before + (sum.had - sum.before) *
                                          element.law.limit / sum.now);
        }
      return limits;
    }



    void
    FiberFriction::accept_step(const System::State &state)
    {
      std::vector<Contact::FrictionMemory::Record> records;
      const std::vector<double>                    before = limits_before();
      struct
      {
        double work = 0., stored = 0.;
      } sums;
      for (unsigned int i = 0; i < elements.size(); ++i)
        {
          const Element     &element = elements[i];
          const Tensor<1, 3> u       = element.displacement(state.current());
          const Tensor<1, 3> kept    = element.law.elastic_part(u);
          if (space.owns(element.fiber_a))
            {
              // The work of a step is that at the mean of its limits.
              sums.work +=
                0.5 * (before[i] + element.law.limit) *
                (element.law.energy_ratio(u) - element.energy_before);
              sums.stored += element.law.energy(kept);
            }
          const Tensor<2, 3> axes =
            element.pair(state.current()).frame(element.orientation);
          records.push_back({element.fiber_a,
                             element.fiber_b,
                             element.s_a,
                             element.s_b,
                             element.weight,
                             element.orientation,
                             axes * kept,
                             element.law.limit});
        }
      memory.set(records);
      placement = 0;
      sum_over_ranks(sums, space.communicator());
      dissipated += sums.work - (sums.stored - stored);
      stored = sums.stored;
    }



    void
    FiberFriction::forget()
    {
      std::vector<Contact::FrictionMemory::Record> none;
      memory.set(none);
      placement = 0;
      stored = dissipated = 0.;
    }



    void
    FiberFriction::set_active(const bool yes)
    {
      if (active != yes)
        placement = 0;
      active = yes;
    }



    void
    FiberFriction::save(ArchiveWriter &archive, const System::State &) const
    {
      memory.save(archive, name() + "/displacements", [this](unsigned int f) {
        return space.owns(f);
      });
      archive.write_number(name() + "/stored", stored);
      archive.write_number(name() + "/dissipated", dissipated);
    }



    void
    FiberFriction::load(const ArchiveReader &archive, const System::State &)
    {
      memory.load(archive, name() + "/displacements", [this](unsigned int f) {
        return space.owns(f);
      });
      placement  = 0;
      stored     = archive.read_number(name() + "/stored");
      dissipated = archive.read_number(name() + "/dissipated");
    }
  } // namespace Contributions
} // namespace Heddle
