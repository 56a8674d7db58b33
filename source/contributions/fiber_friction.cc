#include <heddle/base/reduce.h>
#include <heddle/contact/pair_frame.h>
#include <heddle/contributions/fiber_friction.h>
#include <heddle/contributions/interval_pairs.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

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
    {
    }



    void
    FiberFriction::begin_step(System::State &)
    {
      is_stale = true;
    }



    void
    FiberFriction::update(System::State &state)
    {
      const bool stale = is_stale || ghost_version != state.ghost_version();
      if (Utilities::MPI::max(stale ? 1 : 0, space.communicator()) > 0)
        renew(state);
    }



    void
    FiberFriction::renew(const System::State &state)
    {
      elements.clear();
      for (const Contact::ContactElement &touching : contact.elements())
        if (touching.force > 0.)
          elements.push_back(make_element(state, touching));
      n_elements =
        Utilities::MPI::sum(double(elements.size()), space.communicator());
      if (ghost_version != state.ghost_version())
        pattern_pairs.clear();
      is_stale      = false;
      ghost_version = state.ghost_version();
    }



    FiberFriction::Element
    FiberFriction::make_element(const System::State           &state,
                                const Contact::ContactElement &touching) const
    {
      Element element     = {};
      element.fiber_a     = touching.fiber_a;
      element.fiber_b     = touching.fiber_b;
      element.orientation = touching.orientation;
      element.s_a         = touching.s_a;
      element.s_b         = touching.s_b;
      element.weight      = touching.weight;
      element.normal      = touching.normal;

      const double radius_a = space.fiber(touching.fiber_a).radius,
                   radius_b = space.fiber(touching.fiber_b).radius;
      element.law           = {parameters.friction * touching.force,
                               parameters.reversible_displacement *
                                 std::min(radius_a, radius_b)};
      element.place_a       = place_in_section(
        state, touching.fiber_a, touching.s_a, -radius_a * touching.normal);
      element.place_b = place_in_section(
        state, touching.fiber_b, touching.s_b, radius_b * touching.normal);

      // What was left, turned along; then the motion since the last step,
      // without the rotation that both fibers share.
      const auto left = memory.at(touching, 0.5 * std::min(radius_a, radius_b));
      const Tensor<2, 3> axes =
        frame(state, element, left.orientation, state.current());
      element.offset = transpose(axes) * left.displacement;

      const int          way    = touching.orientation;
      const Tensor<2, 3> before = frame(state, element, way, state.accepted()),
                         now    = frame(state, element, way, state.current());
      const Tensor<1, 3> began =
        separation(state, element).of(state.accepted());
      element.offset -= transpose(now) * (before * began);
      element.offset -= (element.offset * element.normal) * element.normal;
      return element;
    }



    std::array<double, 2>
    FiberFriction::place_in_section(const System::State &state,
                                    const unsigned int   fiber,
                                    const double         s,
                                    const Tensor<1, 3>  &r) const
    {
      if (space.n_blocks_per_node() == 2)
        return {{0., 0.}};
      const System::SectionPoint point = space.locate_section(fiber, s);
      Tensor<1, 3>               g[2];
      for (unsigned int direction = 0; direction < 2; ++direction)
        for (unsigned int i = 0; i < 2; ++i)
          g[direction] +=
            point.values[i] * state.fiber(fiber)[point.blocks[i] + direction];

      // The nearest vector of the section, by the normal equations.
      const double a = g[0] * g[0], b = g[0] * g[1], c = g[1] * g[1];
      const double p = r * g[0], q = r * g[1], determinant = a * c - b * b;
      return {{(c * p - b * q) / determinant, (a * q - b * p) / determinant}};
    }



    void
    FiberFriction::add_particle(const System::State         &state,
                                const unsigned int           fiber,
                                const double                 s,
                                const std::array<double, 2> &place,
                                const double                 sign,
                                Separation                  &separation) const
    {
      const unsigned int          first = state.local_block(fiber);
      const System::MaterialPoint axis  = space.locate(fiber, s);
      for (unsigned int i = 0; i < 4; ++i, ++separation.n)
        {
          separation.blocks[separation.n]  = first + axis.blocks[i];
          separation.weights[separation.n] = sign * axis.values[i];
        }
      if (space.n_blocks_per_node() == 2)
        return;
      const System::SectionPoint section = space.locate_section(fiber, s);
      for (unsigned int direction = 0; direction < 2; ++direction)
        for (unsigned int i = 0; i < 2; ++i, ++separation.n)
          {
            separation.blocks[separation.n] =
              first + section.blocks[i] + direction;
            separation.weights[separation.n] =
              sign * place[direction] * section.values[i];
          }
    }



    FiberFriction::Separation
    FiberFriction::separation(const System::State &state,
                              const Element       &element) const
    {
      Separation result;
      add_particle(
        state, element.fiber_a, element.s_a, element.place_a, 1., result);
      add_particle(
        state, element.fiber_b, element.s_b, element.place_b, -1., result);
      return result;
    }



    Tensor<1, 3>
    FiberFriction::Separation::of(const std::vector<Tensor<1, 3>> &values) const
    {
      Tensor<1, 3> sum;
      for (unsigned int i = 0; i < n; ++i)
        sum += weights[i] * values[blocks[i]];
      return sum;
    }



    Tensor<2, 3>
    FiberFriction::frame(const System::State             &state,
                         const Element                   &element,
                         const int                        orientation,
                         const std::vector<Tensor<1, 3>> &values) const
    {
      Tensor<1, 3> position[2], tangent[2];
      for (unsigned int side = 0; side < 2; ++side)
        {
          const unsigned int f = side == 0 ? element.fiber_a : element.fiber_b;
          const double       s = side == 0 ? element.s_a : element.s_b;
          const System::MaterialPoint point = space.locate(f, s);
          const System::MaterialPoint slope = space.locate_tangent(f, s);
          for (unsigned int i = 0; i < 4; ++i)
            {
              position[side] += point.values[i] *
                                values[state.local_block(f) + point.blocks[i]];
              tangent[side] += slope.values[i] *
                               values[state.local_block(f) + slope.blocks[i]];
            }
        }
      return Contact::pair_frame(
        tangent[0], tangent[1], orientation, position[0] - position[1]);
    }



    Tensor<1, 3>
    FiberFriction::displacement(const Element                   &element,
                                const Separation                &separation,
                                const std::vector<Tensor<1, 3>> &values) const
    {
      const Tensor<1, 3> apart = separation.of(values);
      return element.offset + apart - (apart * element.normal) * element.normal;
    }



    bool
    FiberFriction::needs_new_pattern() const
    {
      const auto pairs = interval_pairs(space, elements);
      return !std::includes(
        pattern_pairs.begin(), pattern_pairs.end(), pairs.begin(), pairs.end());
    }



    void
    FiberFriction::add_pattern(const System::State          &state,
                               System::BlockSystem::Pattern &pattern)
    {
      Contact::extend_pairs(pattern_pairs, interval_pairs(space, elements));
      for (const Contact::CandidatePair &pair : pattern_pairs)
        {
          Element element        = {};
          element.fiber_a        = pair.fiber_a;
          element.fiber_b        = pair.fiber_b;
          element.s_a            = space.middle(pair.fiber_a, pair.interval_a);
          element.s_b            = space.middle(pair.fiber_b, pair.interval_b);
          const Separation apart = separation(state, element);
          pattern.couple(apart.n, apart.blocks.data());
        }
    }



    void
    FiberFriction::assemble(const System::State &state,
                            System::BlockSystem &system)
    {
      constexpr unsigned int              n_most = 3 * Separation::max_blocks;
      std::array<double, n_most>          residual;
      std::array<double, n_most * n_most> tangent;
      for (const Element &element : elements)
        {
          const Separation   apart = separation(state, element);
          const Tensor<1, 3> u = displacement(element, apart, state.current());
          const Tensor<1, 3> force = element.law.force(u);
          const unsigned int n     = 3 * apart.n;
          for (unsigned int i = 0; i < apart.n; ++i)
            for (unsigned int d = 0; d < 3; ++d)
              residual[3 * i + d] = apart.weights[i] * force[d];
          if (system.wants_tangent())
            {
              const Tensor<2, 3> k = element.law.stiffness(u, element.normal);
              for (unsigned int i = 0; i < apart.n; ++i)
                for (unsigned int j = 0; j < apart.n; ++j)
                  for (unsigned int d = 0; d < 3; ++d)
                    for (unsigned int e = 0; e < 3; ++e)
                      tangent[n * (3 * i + d) + 3 * j + e] =
                        apart.weights[i] * apart.weights[j] * k[d][e];
            }
          system.add(
            apart.n, apart.blocks.data(), residual.data(), tangent.data());
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
            const Separation   apart = separation(state, element);
            const Tensor<1, 3> u =
              displacement(element, apart, state.current());
            const Tensor<1, 3> change = apart.of(increment);
            slope += element.law.force(u) * change;
            curvature +=
              change * (element.law.stiffness(u, element.normal) * change);
          }
      return {slope, curvature};
    }



    bool
    FiberFriction::adapt(const System::State &)
    {
      is_stale = true;
      return true;
    }



    void
    FiberFriction::report(const System::State           &state,
                          std::map<std::string, double> &values) const
    {
      std::array<double, 3> sums = {};
      for (const Element &element : elements)
        if (space.owns(element.fiber_a))
          {
            const Tensor<1, 3> u = displacement(
              element, separation(state, element), state.current());
            sums[0] += element.law.energy(element.law.elastic_part(u));
            sums[1] += 1.;
            sums[2] += u.norm() > element.law.reversible ? 1. : 0.;
          }
      sum_over_ranks(sums, space.communicator());
      values["friction_stored[N*mm]"]     = sums[0];
      values["friction_dissipated[N*mm]"] = dissipated;
      values["slipping_part[-]"] = sums[1] > 0. ? sums[2] / sums[1] : 0.;
    }



    void
    FiberFriction::accept_step(const System::State &state)
    {
      std::vector<Contact::FrictionMemory::Record> records;
      double                                       work = 0.;
      for (const Element &element : elements)
        {
          const Tensor<1, 3> u =
            displacement(element, separation(state, element), state.current());
          const Tensor<1, 3> kept = element.law.elastic_part(u);
          const Tensor<2, 3> axes =
            frame(state, element, element.orientation, state.current());
          if (space.owns(element.fiber_a))
            work += element.law.force(u) * (u - kept);
          records.push_back({element.fiber_a,
                             element.fiber_b,
                             element.s_a,
                             element.s_b,
                             element.weight,
                             element.orientation,
                             axes * kept});
        }
      memory.set(records);
      dissipated += Utilities::MPI::sum(work, space.communicator());
      is_stale = true;
    }



    void
    FiberFriction::reject_step(System::State &)
    {
      is_stale = true;
    }



    void
    FiberFriction::save(ArchiveWriter &archive) const
    {
      memory.save(archive, name() + "/displacements", [this](unsigned int f) {
        return space.owns(f);
      });
      archive.write_number(name() + "/dissipated", dissipated);
    }



    void
    FiberFriction::load(const ArchiveReader &archive)
    {
      memory.load(archive, name() + "/displacements", [this](unsigned int f) {
        return space.owns(f);
      });
      dissipated = archive.read_number(name() + "/dissipated");
      is_stale   = true;
    }
  } // namespace Contributions
} // namespace Heddle
