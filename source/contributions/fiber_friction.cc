#include <heddle/base/reduce.h>
#include <heddle/contact/pair_turning.h>
#include <heddle/contributions/fiber_friction.h>
#include <heddle/contributions/interval_pairs.h>

#include <deal.II/base/mpi.h>

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
    FiberFriction::probe(System::State &state)
    {
      place_elements(state);
    }



    void
    FiberFriction::place_elements(const System::State &state)
    {
      elements.clear();
      for (const Contact::ContactElement &touching : contact.elements())
        if (touching.force > 0.)
          elements.push_back(make_element(state, touching));
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
      element.place_a       = place_in_section(
        state, touching.fiber_a, touching.s_a, -radius_a * touching.normal);
      element.place_b = place_in_section(
        state, touching.fiber_b, touching.s_b, radius_b * touching.normal);

      const Pair   now    = pair(state, element, state.current());
      const double cosine = now.tangent[0] * now.tangent[1] /
                            (now.tangent[0].norm() * now.tangent[1].norm());
      element.law = {
        coefficients(element.fiber_a, element.fiber_b, cosine) * touching.force,
        parameters.reversible_displacement * std::min(radius_a, radius_b)};
      set_displacement(state, touching, now, element);
      return element;
    }



    void
    FiberFriction::set_displacement(const System::State           &state,
                                    const Contact::ContactElement &touching,
                                    const Pair                    &now,
                                    Element &element) const
    {
      const double radius_a     = space.fiber(touching.fiber_a).radius,
                   radius_b     = space.fiber(touching.fiber_b).radius;
      const Pair         then   = pair(state, element, state.accepted());
      const Tensor<2, 3> before = then.frame(touching.orientation),
                         frame  = now.frame(touching.orientation);
      element.axes[0] = frame[0] - (frame[0] * element.normal) * element.normal;
      element.axes[0] /= element.axes[0].norm();
      element.axes[1] = cross_product_3d(element.normal, element.axes[0]);

      // The motion since the last step, without the rotation that both fibers
      // share.
      const Separation   apart = separation(state, element);
      const Tensor<1, 3> began =
        transpose(frame) * (before * apart.of(state.accepted()));
      Tensor<1, 3> motion = apart.of(state.current()) - began;
      motion -= (motion * element.normal) * element.normal;

      // Where nothing touched within this motion a gap closed since then, at a
      // steady rate: in this part of the step.
      const double gap = before[2] * then.connection - (radius_a + radius_b);
      element.share    = 1.;
      if (gap > 0. && !memory.touched(touching, motion.norm()))
        element.share =
          touching.gap < 0. ? touching.gap / (touching.gap - gap) : 0.;

      // What was left, turned along, and the motion.
      const auto left = memory.at(touching, 0.5 * std::min(radius_a, radius_b));
      element.energy_before = element.law.energy_ratio(left.displacement);
      element.offset =
        transpose(now.frame(left.orientation)) * left.displacement +
        element.share * motion;
      element.offset -= (element.offset * element.normal) * element.normal;
      lean(element, now, apart.of(state.current()));
      const auto linear = change(element, apart, state.current());
      for (unsigned int k = 0; k < 2; ++k)
        element.offset -= linear[k] * element.axes[k];
    }



    void
    FiberFriction::lean(Element            &element,
                        const Pair         &now,
                        const Tensor<1, 3> &arm) const
    {
      for (unsigned int k = 0; k < 2; ++k)
        element.by_separation[k] = element.share * element.axes[k];
      if (space.n_blocks_per_node() != 2)
        return;

      // The rotation w of the pair takes the arm d between the particles along:
      // a motion less w x d rubs. The moment of both forces is borne by what
      // turns the pair, so all moments balance. On surfaces there is no arm.
      const auto turning = Contact::pair_turning(
        now.tangent[0], now.tangent[1], element.orientation, now.connection);
      const double along  = arm * element.axes[0],
                   across = arm * element.axes[1], up = arm * element.normal;
      const auto left_by = [&](const Tensor<1, 3> *w, const unsigned int k) {
        return element.share *
               (k == 0 ? across * w[2] - up * w[1] : up * w[0] - along * w[2]);
      };
      for (unsigned int k = 0; k < 2; ++k)
        {
          element.by_separation[k] += left_by(turning.by_connection, k);
          for (unsigned int side = 0; side < 2; ++side)
            element.by_tangent[side][k] = left_by(turning.by_tangent[side], k);
        }
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
        {
          const System::MaterialPoint slope = space.locate_tangent(fiber, s);
          for (unsigned int i = 0; i < 4; ++i)
            separation.slopes[separation.n - 4 + i] = slope.values[i];
          return;
        }
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



    FiberFriction::Pair
    FiberFriction::pair(const System::State             &state,
                        const Element                   &element,
                        const std::vector<Tensor<1, 3>> &values) const
    {
      Pair result;
      for (unsigned int side = 0; side < 2; ++side)
        {
          const unsigned int f = side == 0 ? element.fiber_a : element.fiber_b;
          const double       s = side == 0 ? element.s_a : element.s_b;
          const System::MaterialPoint point = space.locate(f, s);
          const System::MaterialPoint slope = space.locate_tangent(f, s);
          const unsigned int          first = state.local_block(f);
          Tensor<1, 3>                position;
          for (unsigned int i = 0; i < 4; ++i)
            {
              position += point.values[i] * values[first + point.blocks[i]];
              result.tangent[side] +=
                slope.values[i] * values[first + slope.blocks[i]];
            }
          result.connection += (side == 0 ? 1. : -1.) * position;
        }
      return result;
    }



    Tensor<2, 3>
    FiberFriction::Pair::frame(const int orientation) const
    {
      return Contact::pair_frame(
        tangent[0], tangent[1], orientation, connection);
    }



    FiberFriction::Derivative::Derivative(const Element    &element,
                                          const Separation &separation)
    {
      for (unsigned int k = 0; k < 2; ++k)
        for (unsigned int i = 0; i < separation.n; ++i)
          rows[k][i] = separation.weights[i] * element.by_separation[k] +
                       separation.slopes[i] *
                         element.by_tangent[2 * i < separation.n ? 0 : 1][k];
    }



    std::array<double, 2>
    FiberFriction::change(const Element                   &element,
                          const Separation                &separation,
                          const std::vector<Tensor<1, 3>> &values)
    {
      const Derivative      derivative(element, separation);
      std::array<double, 2> sums = {};
      for (unsigned int k = 0; k < 2; ++k)
        for (unsigned int i = 0; i < separation.n; ++i)
          sums[k] += derivative.rows[k][i] * values[separation.blocks[i]];
      return sums;
    }



    Tensor<1, 3>
    FiberFriction::displacement(const Element                   &element,
                                const Separation                &separation,
                                const std::vector<Tensor<1, 3>> &values) const
    {
      const auto moved = change(element, separation, values);
      return element.offset + moved[0] * element.axes[0] +
             moved[1] * element.axes[1];
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
          const Derivative   by(element, apart);
          const unsigned int n     = 3 * apart.n;
          const double       along = force * element.axes[0],
                       across      = force * element.axes[1];
          for (unsigned int i = 0; i < apart.n; ++i)
            for (unsigned int d = 0; d < 3; ++d)
              residual[3 * i + d] =
                along * by.rows[0][i][d] + across * by.rows[1][i][d];
          if (system.wants_tangent())
            {
              const Tensor<2, 3> k = element.law.stiffness(u, element.normal);
              const double       both = element.axes[0] * (k * element.axes[1]);
              const double first      = element.axes[0] * (k * element.axes[0]),
                           second     = element.axes[1] * (k * element.axes[1]);
              for (unsigned int j = 0; j < apart.n; ++j)
                {
                  const Tensor<1, 3> f =
                    first * by.rows[0][j] + both * by.rows[1][j];
                  const Tensor<1, 3> g =
                    both * by.rows[0][j] + second * by.rows[1][j];
                  for (unsigned int i = 0; i < apart.n; ++i)
                    for (unsigned int d = 0; d < 3; ++d)
                      for (unsigned int e = 0; e < 3; ++e)
                        tangent[n * (3 * i + d) + 3 * j + e] =
                          by.rows[0][i][d] * f[e] + by.rows[1][i][d] * g[e];
                }
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
            const auto         moved = change(element, apart, increment);
            const Tensor<1, 3> motion =
              moved[0] * element.axes[0] + moved[1] * element.axes[1];
            slope += element.law.force(u) * motion;
            curvature +=
              motion * (element.law.stiffness(u, element.normal) * motion);
          }
      return {slope, curvature};
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



    std::vector<double>
    FiberFriction::limits_before() const
    {
      using Fibers = std::pair<unsigned int, unsigned int>;
      std::map<Fibers, double> limits;
      for (const Element &element : elements)
        limits[{element.fiber_a, element.fiber_b}] += element.law.limit;
      for (auto &limit : limits)
        limit.second = memory.limit(limit.first.first, limit.first.second) /
                       std::max(limit.second, 1e-300);
      std::vector<double> ratios;
      for (const Element &element : elements)
        ratios.push_back(limits[{element.fiber_a, element.fiber_b}]);
      return ratios;
    }



    void
    FiberFriction::accept_step(const System::State &state)
    {
      std::vector<Contact::FrictionMemory::Record> records;
      std::array<double, 2>                        sums   = {};
      const std::vector<double>                    before = limits_before();
      for (unsigned int i = 0; i < elements.size(); ++i)
        {
          const Element     &element = elements[i];
          const Tensor<1, 3> u =
            displacement(element, separation(state, element), state.current());
          const Tensor<1, 3> kept = element.law.elastic_part(u);
          if (space.owns(element.fiber_a))
            {
              // The work of a step is that at the mean of its limits.
              sums[0] += 0.5 * (1. + before[i]) * element.law.limit *
                         (element.law.energy_ratio(u) - element.energy_before);
              sums[1] += element.law.energy(kept);
            }
          const Tensor<2, 3> axes =
            pair(state, element, state.current()).frame(element.orientation);
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
      sum_over_ranks(sums, space.communicator());
      dissipated += sums[0] - (sums[1] - stored);
      stored = sums[1];
    }



    void
    FiberFriction::save(ArchiveWriter &archive) const
    {
      memory.save(archive, name() + "/displacements", [this](unsigned int f) {
        return space.owns(f);
      });
      archive.write_number(name() + "/stored", stored);
      archive.write_number(name() + "/dissipated", dissipated);
    }



    void
    FiberFriction::load(const ArchiveReader &archive)
    {
      memory.load(archive, name() + "/displacements", [this](unsigned int f) {
        return space.owns(f);
      });
      stored     = archive.read_number(name() + "/stored");
      dissipated = archive.read_number(name() + "/dissipated");
    }
  } // namespace Contributions
} // namespace Heddle
