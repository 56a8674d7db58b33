#include <heddle/base/normals.h>
#include <heddle/base/reduce.h>
#include <heddle/base/throw_together.h>
#include <heddle/contributions/supports.h>
#include <heddle/system/block_archive.h>

#include <deal.II/physics/transformations.h>

#include <algorithm>
#include <cmath>

namespace Heddle
{
  namespace Contributions
  {
    namespace
    {
      /** Of the largest angle by which a tangent is turned in an iteration.
       * Only its direction is prescribed: from a right angle on it would find
       * its length backwards. */
      constexpr double least_cosine = 0.3;



      /** The direction of @p goal or, if that is too far from @p now, one on
       * the way. */
      Tensor<1, 3>
      direction_towards(const Tensor<1, 3> &goal, const Tensor<1, 3> &now)
      {
        const Tensor<1, 3> begin = now / now.norm(), end = goal / goal.norm();
        const double       cosine = begin * end;
        if (cosine >= least_cosine)
          return end;
        Tensor<1, 3> across = end - cosine * begin;
        // Straight back any way is as good as another.
        if (across.norm() < 1e-6)
          across = two_normals(begin)[0];
        return least_cosine * begin +
               std::sqrt(1. - least_cosine * least_cosine) * across /
                 across.norm();
      }



      /** Rows: the direction of @p tangent, and two normals of it. */
      Tensor<2, 3>
      frame_along(const Tensor<1, 3> &tangent)
      {
        const auto   normals = two_normals(tangent);
        Tensor<2, 3> frame;
        frame[0] = tangent / tangent.norm();
        frame[1] = normals[0];
        frame[2] = normals[1];
        return frame;
      }



      /** Rows: what @p turned makes of the component @p first, and of the two
       * others. */
      Tensor<2, 3>
      turned_frame(const Tensor<2, 3> &turned, const unsigned int first)
      {
        Tensor<2, 3> frame;
        for (unsigned int d = 0; d < 3; ++d)
          frame[d] = transpose(turned)[(first + d) % 3];
        return frame;
      }
    } // namespace



    Supports::Supports(const System::FiberSpace        &space,
                       const std::vector<Tensor<1, 3>> &reference,
                       const SupportList               &supports,
                       const bool                       will_settle)
      : space(space)
      , supports(supports)
      , reference(reference)
      , blocks(
          find_held_blocks(space, reference, supports, nullptr, will_settle))
      , reactions(supports.size())
    {
      for (const auto &support : supports)
        {
          Motion motion;
          for (unsigned int d = 0; d < 3; ++d)
            if (!support->is_free(d))
              motion.displacement[d] = std::make_unique<Expression>(
                support->displacement[d],
                support->entry(std::string("Displacement ") + "xyz"[d]));
          if (support->section == SupportedSection::turned ||
              support->yarns_are_bodies || support->slides_along)
            {
              motion.angle = std::make_unique<Expression>(
                support->angle, support->entry("Turn angle"));
              motion.axis = support->axis / support->axis.norm();
            }
          motions.push_back(std::move(motion));
        }

      // A fabric settles for long before it is loaded: what a formula has no
      // value for is told now, as far as it is known.
      for (const double load_factor : {0., 1.})
        for (const HeldBlock &held : blocks)
          target(held, load_factor);
    }



    void
    Supports::begin_stage(const System::State &state)
    {
      reference.assign(state.current().begin(),
                       state.current().begin() + state.n_owned_blocks());
      blocks = find_held_blocks(space, reference, supports, state.matrix());
      accepted_load_factor.reset();
      begins_stage = true;
    }



    void
    Supports::begin_step(System::State &state)
    {
      // Whatever formulas say of this load factor they say again to
      // constrain().
      throw_together(
        [&]() {
          for (const HeldBlock &held : blocks)
            if (held.local_block(state) != HeldBlock::nobody)
              target(held, state.load_factor);
        },
        space.communicator());
    }



    Tensor<2, 3>
    Supports::rotation(const HeldBlock &held, const double load_factor) const
    {
      for (const unsigned int holder : held.holder)
        if (holder != HeldBlock::nobody && motions[holder].angle)
          return Physics::Transformations::Rotations::rotation_matrix_3d(
            motions[holder].axis,
            motions[holder].angle->value(held.position - origin, load_factor));
      return unit_symmetric_tensor<3>();
    }



    std::optional<unsigned int>
    Supports::slides_along(const HeldBlock &held) const
    {
      if (held.kind == HeldBlock::Kind::position && !held.is_in_matrix())
        for (const unsigned int holder : held.holder)
          if (holder != HeldBlock::nobody && supports[holder]->slides_along)
            return supports[holder]->slides_along;
      return {};
    }



    Tensor<1, 3>
    Supports::target(const HeldBlock &held, const double load_factor) const
    {
      if (held.kind == HeldBlock::Kind::tangent)
        return held.reference;
      const Tensor<2, 3> turned = rotation(held, load_factor);
      if (held.kind != HeldBlock::Kind::position)
        return turned * held.reference;

      // A node moves as its position does, and turns about that with its body.
      Tensor<1, 3> where =
        held.position + turned * (held.reference - held.position);
      for (unsigned int d = 0; d < 3; ++d)
        if (held.holder[d] != HeldBlock::nobody)
          where[d] += motions[held.holder[d]].displacement[d]->value(
            held.position - origin, load_factor);
      return where;
    }



    std::optional<Tensor<1, 3>>
    Supports::prescribed_position(const unsigned int f,
                                  const unsigned int node,
                                  const double       load_factor) const
    {
      const auto key = std::make_pair(f, node * space.n_blocks_per_node());
      const auto found =
        std::lower_bound(blocks.begin(),
                         blocks.end(),
                         key,
                         [](const auto &held, const auto &of) {
                           return std::make_pair(held.fiber, held.block) < of;
                         });
      if (found == blocks.end() ||
          std::make_pair(found->fiber, found->block) != key ||
          slides_along(*found) ||
          std::count(
            found->holder.begin(), found->holder.end(), HeldBlock::nobody) > 0)
        return {};
      return target(*found, load_factor);
    }



    void
    Supports::constrain(const System::State             &state,
                        std::vector<System::Constraint> &constraints) const
    {
      for (const HeldBlock &held : blocks)
        if (held.local_block(state) != HeldBlock::nobody)
          {
            System::Constraint constraint = {};
            constraint.block              = held.local_block(state);
            constraint.frame              = unit_symmetric_tensor<3>();
            const Tensor<1, 3> goal       = target(held, state.load_factor);
            Tensor<1, 3> motion = goal - state.current()[constraint.block];
            if (held.kind == HeldBlock::Kind::direction)
              {
                const Tensor<1, 3> &now = state.current()[constraint.block];
                constraint.frame = frame_along(direction_towards(goal, now));
                constraint.fixed = {{false, true, true}};
                motion           = -1. * (constraint.frame * now);
              }
            else if (const auto free_component = slides_along(held))
              {
                constraint.frame = turned_frame(
                  rotation(held, state.load_factor), *free_component);
                constraint.fixed = {{false, true, true}};
                motion           = constraint.frame * motion;
              }
            else
              for (unsigned int d = 0; d < 3; ++d)
                constraint.fixed[d] = held.holder[d] != HeldBlock::nobody;
            for (unsigned int d = 0; d < 3; ++d)
              constraint.pending[d] = constraint.fixed[d] ? motion[d] : 0.;
            constraints.push_back(constraint);
          }
    }



    void
    Supports::observe(const System::BlockSystem &system)
    {
      std::fill(reactions.begin(), reactions.end(), Reaction());
      std::vector<Tensor<1, 3>> forces(system.state.n_owned_blocks());
      for (const HeldBlock &held : blocks)
        if (held.local_block(system.state) < forces.size())
          {
            const unsigned int block = held.local_block(system.state);

            // What is conjugate to a section vector or a tangent g is a moment
            // over its length: g x f. It adds to that of the forces.
            for (unsigned int d = 0; d < 3; ++d)
              if (held.holder[d] != HeldBlock::nobody)
                {
                  Reaction    &sum = reactions[held.holder[d]];
                  Tensor<1, 3> force;
                  force[d] = forces[block][d] = system.residual()[block][d];
                  if (held.kind == HeldBlock::Kind::position)
                    sum.force += force;
                  sum.moment +=
                    cross_product_3d(system.state.current()[block], force);
                  if (held.is_in_matrix())
                    sum.of_matrix += force;
                }
          }
      work.set_forces(forces);
      sum_over_ranks(reactions, space.communicator());
    }



    void
    Supports::report(const System::State &,
                     std::map<std::string, double> &values) const
    {
      for (unsigned int i = 0; i < reactions.size(); ++i)
        for (unsigned int d = 0; d < 3; ++d)
          {
            const std::string begin = "support_" + std::to_string(i + 1);
            values[begin + "_force_" + "xyz"[d] + "[N]"] =
              reactions[i].force[d];
            values[begin + "_moment_" + "xyz"[d] + "[N*mm]"] =
              reactions[i].moment[d];
            if (!supports[i]->matrix_sides.empty())
              values[begin + "_matrix_force_" + "xyz"[d] + "[N]"] =
                reactions[i].of_matrix[d];
          }
      values["external_work[N*mm]"] += work.value();
    }



    void
    Supports::accept_step(const System::State &state)
    {
      if (begins_stage)
        work.add_step(state);
      else
        {
          work.add_step(state, turns_of_step(state));
          accepted_load_factor = state.load_factor;
        }
      begins_stage = false;
    }



    std::vector<ExternalWork::Turn>
    Supports::turns_of_step(const System::State &state) const
    {
      std::vector<ExternalWork::Turn> turns;
      for (const HeldBlock &held : blocks)
        {
          const unsigned int block = held.local_block(state);
          if (block >= state.n_owned_blocks() ||
              held.kind == HeldBlock::Kind::tangent)
            continue;
          for (const unsigned int holder : held.holder)
            if (holder != HeldBlock::nobody && motions[holder].angle)
              {
                const auto angle = [&](const double load_factor) {
                  return motions[holder].angle->value(held.position - origin,
                                                      load_factor);
                };
                Tensor<1, 3> lever = state.accepted()[block];
                if (held.kind == HeldBlock::Kind::position)
                  {
                    lever = held.reference - held.position;
                    if (accepted_load_factor)
                      lever = rotation(held, *accepted_load_factor) * lever;
                  }
                const double before =
                  accepted_load_factor ? angle(*accepted_load_factor) : 0.;
                turns.push_back(
                  {block,
                   (angle(state.load_factor) - before) * motions[holder].axis,
                   lever});
                break;
              }
        }
      return turns;
    }



    void
    Supports::save(ArchiveWriter &archive, const System::State &state) const
    {
      System::write_blocks(archive, name() + "/reference", state, reference);
      work.save(archive, name(), state);
      archive.write_number(name() + "/has_moved",
                           accepted_load_factor ? 1. : 0.);
    }



    void
    Supports::load(const ArchiveReader &archive, const System::State &state)
    {
      reference = System::read_blocks(archive, name() + "/reference", state);
      blocks    = find_held_blocks(space, reference, supports, state.matrix());
      work.load(archive, name(), state);
      accepted_load_factor.reset();
      if (archive.read_number(name() + "/has_moved") > 0.)
        accepted_load_factor = state.load_factor;
    }
  } // namespace Contributions
} // namespace Heddle
