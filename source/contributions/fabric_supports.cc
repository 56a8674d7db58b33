#include <heddle/base/reduce.h>
#include <heddle/base/yarn_set.h>
#include <heddle/contributions/fabric_supports.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace Heddle
{
  namespace Contributions
  {
    namespace
    {
      /** Directions of a fabric. */
      constexpr unsigned int n_directions = 2;

      const std::array<std::string, n_directions> direction_names = {
        {word(YarnSet::warp), word(YarnSet::weft)}};

      /** Strains, and angles, closer than this are the same [-]. */
      constexpr double same_strain = 1e-12;

      /** 0 for the ends of warp yarns, 1 for those of weft yarns. */
      unsigned int
      family_of(const HeldBlock &held)
      {
        for (const unsigned int holder : held.holder)
          if (holder != HeldBlock::nobody)
            return holder / 2;
        return 0;
      }



      /** What is held of a force on a block, or of its motion. */
      Tensor<1, 3>
      held_part(const HeldBlock &held, const Tensor<1, 3> &force)
      {
        Tensor<1, 3> part;
        for (unsigned int d = 0; d < 3; ++d)
          if (held.holder[d] != HeldBlock::nobody)
            part[d] = force[d];
        return part;
      }



      /** The turn of what is held about z, by the shear angle [-]. */
      Tensor<1, 3>
      turn_of(const HeldBlock &held, const FabricMotion::Both<double> &rates)
      {
        return Tensor<1, 3>({0., 0., rates[family_of(held)]});
      }
    } // namespace



    FabricSupports::FabricSupports(const System::FiberSpace        &space,
                                   const std::vector<Tensor<1, 3>> &reference,
                                   const FabricCase                &test,
                                   const FabricSize                &size)
      : Supports(space, reference, test.supports)
      , test(test)
      , size(size)
    {
    }



    void
    FabricSupports::begin_stage(const System::State &state)
    {
      Supports::begin_stage(state);
      find_sides(state);
      if (test.bending)
        origin[2] = neutral_height(state);
    }



    double
    FabricSupports::neutral_height(const System::State &state) const
    {
      std::set<unsigned int> bent;
      for (const HeldBlock &held : held_blocks())
        if (!held.is_in_matrix() &&
            family_of(held) == test.bending->direction())
          bent.insert(held.fiber);

      struct
      {
        double height = 0., stiffness = 0.;
      } sums;
      const System::FiberSpace &space = state.space;
      const auto                owned = space.owned_fibers();
      const unsigned int        n     = space.n_blocks_per_node();
      for (const unsigned int f : bent)
        if (f >= owned.first && f < owned.second)
          for (unsigned int i = 0; i + 1 < space.fiber(f).n_nodes; ++i)
            {
              const Tensor<1, 3> &a = state.fiber(f)[i * n],
                                 &b = state.fiber(f)[(i + 1) * n];
              const double stiffness =
                space.fiber(f).section.axial * (b - a).norm();
              sums.height += 0.5 * stiffness * (a[2] + b[2]);
              sums.stiffness += stiffness;
            }
      sum_over_ranks(sums, space.communicator());
      return sums.height / sums.stiffness;
    }



    void
    FabricSupports::find_sides(const System::State &state)
    {
      // Nodes in corners are of two sides. One of these that is free in its
      // direction has no force, and what holds the corner is of the other.
      std::array<std::set<unsigned int>, n_sides> nodes;
      if (state.matrix())
        for (unsigned int side = 0; side < n_sides; ++side)
          if (!test.supports[side]->is_free(side / 2))
            {
              const auto on_side = state.matrix()->nodes_on_side(side);
              nodes[side].insert(on_side.begin(), on_side.end());
            }

      sides_of.clear();
      std::array<Tensor<1, 3>, n_sides> sums;
      std::array<double, n_sides>       counts = {};
      for (const HeldBlock &held : held_blocks())
        {
          unsigned int bits = 0;
          for (unsigned int side = 0; side < n_sides; ++side)
            if (held.is_in_matrix())
              bits |= nodes[side].count(held.block) << side;
            else
              for (const unsigned int holder : held.holder)
                if (holder == side)
                  bits |= 1u << side;
          sides_of.push_back(bits);
          for (unsigned int side = 0; side < n_sides; ++side)
            if (!held.is_in_matrix() &&
                held.kind == HeldBlock::Kind::position && (bits >> side & 1u))
              {
                sums[side] += held.reference;
                counts[side] += 1.;
              }
        }
      for (unsigned int side = 0; side < n_sides; ++side)
        rest_middles[side] = sums[side] / counts[side];
      for (unsigned int i = 0; i < n_directions; ++i)
        origin[i] = 0.5 * (rest_middles[2 * i][i] + rest_middles[2 * i + 1][i]);
      find_areas();
      rest_length = lengths(rest_middles, 0.);
      now         = {};
      now.length  = rest_length;
      last = before = now;
    }



    void
    FabricSupports::find_areas()
    {
      // Yarns stand for their share of a wide fabric, also outside of the
      // outermost ones. A matrix ends where it ends.
      matrix_width                         = {};
      const double none                    = std::numeric_limits<double>::max();
      std::array<double, n_directions> low = {{none, none}},
                                       high = {{-none, -none}};
      for (const HeldBlock &held : held_blocks())
        if (held.is_in_matrix())
          for (unsigned int i = 0; i < n_directions; ++i)
            {
              low[i]              = std::min(low[i], held.reference[i]);
              high[i]             = std::max(high[i], held.reference[i]);
              matrix_width[1 - i] = high[i] - low[i];
            }
      sheared_area = matrix_width[0] > 0. ? matrix_width[0] * matrix_width[1]
                                          : size.width[0] * size.width[1];
    }



    FabricSupports::Both<double>
    FabricSupports::lengths(const std::array<Tensor<1, 3>, n_sides> &middles,
                            const double load_factor) const
    {
      const auto   along = test.motion.directions(load_factor);
      const double area  = cross_product_3d(along[0], along[1])[2];
      Both<double> result;
      for (unsigned int i = 0; i < n_directions; ++i)
        {
          // What one family extends along its direction, whatever it is
          // displaced along that of the other.
          const Tensor<1, 3> span = middles[2 * i + 1] - middles[2 * i];
          const double part = (i == 0 ? cross_product_3d(span, along[1])[2]
                                      : cross_product_3d(along[0], span)[2]) /
                              area;
          result[i] = part * along[i].norm();
        }
      return result;
    }



    FabricSupports::Kinematics::Kinematics(const FabricMotion &motion,
                                           const double        load_factor)
      : along(motion.directions(load_factor))
      , turning(motion.turning(load_factor))
      , turn_rates(motion.turn_rates())
    {
      for (unsigned int i = 0; i < n_directions; ++i)
        stretch[i] = 1. + motion.strain(i, load_factor);
    }



    void
    FabricSupports::add_position(const HeldBlock    &held,
                                 const unsigned int  sides,
                                 const Tensor<1, 3> &force,
                                 const Tensor<1, 3> &place,
                                 const Kinematics   &kinematics,
                                 Sums               &sums) const
    {
      const bool         in_matrix = held.is_in_matrix();
      const Tensor<1, 3> middle    = held.position - origin;
      double             couple    = 0.;
      Tensor<1, 3>       lever     = place - origin;
      for (unsigned int i = 0; i < n_directions; ++i)
        {
          sums.work[i] += (force * kinematics.along[i]) * middle[i];
          couple +=
            (force * kinematics.turning[i]) * middle[i] * kinematics.stretch[i];
          lever -= kinematics.along[i] * middle[i] * kinematics.stretch[i];
        }
      // Ends turn with their yarn, about its middle or where the sheet has
      // them.
      if (!in_matrix)
        couple +=
          force * cross_product_3d(turn_of(held, kinematics.turn_rates), lever);
      sums.couple += couple;
      sums.matrix_couple += in_matrix ? couple : 0.;

      for (unsigned int side = 0; side < n_sides; ++side)
        if (sides >> side & 1u)
          {
            SideSums &sum = sums.sides[side];
            sum.force += force;
            if (in_matrix)
              sum.of_matrix += force;
            else
              {
                // How far an end has slid is no length.
                sum.ends +=
                  test.supports[side]->slides_along ? place - lever : place;
                sum.n_ends += 1.;
              }
          }
    }



    void
    FabricSupports::observe(const System::BlockSystem &system)
    {
      Supports::observe(system);
      const System::State &state = system.state;
      const Kinematics     kinematics(test.motion, state.load_factor);

      Sums sums;
      for (unsigned int k = 0; k < sides_of.size(); ++k)
        {
          const HeldBlock   &held  = held_blocks()[k];
          const unsigned int block = held.local_block(state);
          if (block >= state.n_owned_blocks())
            continue;
          const Tensor<1, 3>  force = held_part(held, system.residual()[block]);
          const Tensor<1, 3> &place = state.current()[block];
          if (held.kind == HeldBlock::Kind::position)
            add_position(held, sides_of[k], force, place, kinematics, sums);
          else
            sums.couple +=
              force *
              cross_product_3d(turn_of(held, kinematics.turn_rates), place);
          if (test.bending)
            {
              const double work =
                bending_work(held, force, place, state.load_factor);
              sums.bending += work;
              sums.of_matrix += held.is_in_matrix() ? work : 0.;
            }
        }
      sum_over_ranks(sums, state.space.communicator());
      now = measure(sums, kinematics, state.load_factor);
    }



    FabricSupports::Measured
    FabricSupports::measure(const Sums       &sums,
                            const Kinematics &kinematics,
                            const double      load_factor) const
    {
      std::array<Tensor<1, 3>, n_sides> middles;
      for (unsigned int side = 0; side < n_sides; ++side)
        middles[side] = sums.sides[side].ends / sums.sides[side].n_ends;

      Measured result;
      result.length = lengths(middles, load_factor);
      for (unsigned int i = 0; i < n_directions; ++i)
        {
          const SideSums    &first = sums.sides[2 * i];
          const SideSums    &last  = sums.sides[2 * i + 1];
          Both<Tensor<1, 3>> outward;
          outward.fill(kinematics.along[i] / kinematics.along[i].norm());
          if (test.bending && test.bending->direction() == i)
            {
              for (unsigned int end = 0; end < 2; ++end)
                outward[end] = test.bending->tangent(
                  rest_middles[2 * i + end] - origin, load_factor);
              result.length[i] = rest_length[i];
            }
          result.force[i] =
            0.5 * (last.force * outward[1] - first.force * outward[0]);
          result.matrix_force[i] =
            0.5 * (last.of_matrix * outward[1] - first.of_matrix * outward[0]);
          result.work_force[i] = sums.work[i] / rest_length[i];
        }
      result.angle         = test.motion.shear_angle(load_factor);
      result.couple        = sums.couple;
      result.matrix_couple = sums.matrix_couple;
      if (test.bending)
        {
          // The sides turn by the curvature times their distance.
          const double length  = rest_length[test.bending->direction()];
          result.curvature     = test.bending->curvature(load_factor);
          result.moment        = sums.bending / length;
          result.matrix_moment = sums.of_matrix / length;
        }
      return result;
    }



    double
    FabricSupports::bending_work(const HeldBlock    &held,
                                 const Tensor<1, 3> &force,
                                 const Tensor<1, 3> &value,
                                 const double        load_factor) const
    {
      const FabricBending &bending = *test.bending;
      const Tensor<1, 3>   place   = held.position - origin;
      const Tensor<1, 3>   turn    = bending.turn_rate(place);
      if (held.kind != HeldBlock::Kind::position)
        return force * cross_product_3d(turn, value);
      // The ends of a yarn turn about their middle.
      const Tensor<1, 3> lever =
        value - held.position - bending.displacement(place, load_factor);
      return force * (bending.displacement_rate(place, load_factor) +
                      cross_product_3d(turn, lever));
    }



    double
    FabricSupports::slope(const double value,
                          const double value_before,
                          const double at,
                          const double at_before)
    {
      return std::abs(at - at_before) > same_strain
               ? (value - value_before) / (at - at_before)
               : std::numeric_limits<double>::quiet_NaN();
    }



    void
    FabricSupports::report(const System::State           &state,
                           std::map<std::string, double> &values) const
    {
      Supports::report(state, values);
      const bool has_matrix = !test.supports[0]->matrix_sides.empty();
      for (unsigned int i = 0; i < n_directions; ++i)
        {
          const std::string name      = direction_names[i];
          const double      length    = rest_length[i];
          const auto        per_width = [&](const Measured &measured) {
            const double of_matrix = measured.matrix_force[i];
            return (measured.force[i] - of_matrix) / size.width[i] +
                   (has_matrix ? of_matrix / matrix_width[i] : 0.);
          };
          const auto strain = [&](const Measured &measured) {
            return length > 0. ? measured.length[i] / length - 1. : 0.;
          };
          values[name + "_length[mm]"]            = last.length[i];
          values[name + "_strain[-]"]             = strain(last);
          values[name + "_force[N]"]              = last.force[i];
          values[name + "_force_per_width[N/mm]"] = per_width(last);
          values[name + "_force_per_yarn[N]"] = last.force[i] / size.n_yarns[i];
          if (has_matrix)
            values[name + "_matrix_force[N]"] = last.matrix_force[i];
          if (test.pulls[i])
            values[name + "_work_force[N]"] = last.work_force[i];
          values[name + "_tangent_stiffness[N/mm]"] = slope(
            per_width(last), per_width(before), strain(last), strain(before));
        }
      values["shear_angle[deg]"]            = last.angle * 180. / numbers::PI;
      values["shear_couple[N*mm]"]          = last.couple;
      values["shear_couple_per_area[N/mm]"] = last.couple / sheared_area;
      if (has_matrix)
        values["shear_matrix_couple[N*mm]"] = last.matrix_couple;
      values["shear_tangent_stiffness[N*mm/rad]"] =
        slope(last.couple, before.couple, last.angle, before.angle);
      if (test.bending)
        report_bending(values);
    }



    void
    FabricSupports::report_bending(std::map<std::string, double> &values) const
    {
      const unsigned int i         = test.bending->direction();
      const bool         in_matrix = !test.supports[0]->matrix_sides.empty();
      const auto         per_width = [&](const Measured &measured) {
        return (measured.moment - measured.matrix_moment) / size.width[i] +
               (in_matrix ? measured.matrix_moment / matrix_width[i] : 0.);
      };
      values["bending_curvature[1/mm]"]     = last.curvature;
      values["bending_moment[N*mm]"]        = last.moment;
      values["bending_moment_per_width[N]"] = per_width(last);
      values["bending_stiffness[N*mm]"]     = slope(
        per_width(last), per_width(before), last.curvature, before.curvature);
      if (in_matrix)
        values["bending_matrix_moment[N*mm]"] = last.matrix_moment;
    }



    void
    FabricSupports::accept_step(const System::State &state)
    {
      Supports::accept_step(state);
      before = last;
      last   = now;
    }



    bool
    FabricSupports::hold_askew(const ArchiveReader &archive)
    {
      for (const std::string motion :
           {"supports/shear angle", "supports/curvature"})
        if (archive.has(motion) &&
            std::abs(archive.read_number(motion)) > same_strain)
          return true;
      return false;
    }



    void
    FabricSupports::save(ArchiveWriter       &archive,
                         const System::State &state) const
    {
      Supports::save(archive, state);
      for (unsigned int i = 0; i < n_directions; ++i)
        {
          const std::string begin = name() + "/" + direction_names[i];
          archive.write_number(begin + " length", last.length[i]);
          archive.write_number(begin + " force", last.force[i]);
          archive.write_number(begin + " matrix force", last.matrix_force[i]);
        }
      archive.write_number(name() + "/shear angle", last.angle);
      archive.write_number(name() + "/shear couple", last.couple);
      if (test.bending)
        {
          archive.write_number(name() + "/origin z", origin[2]);
          archive.write_number(name() + "/curvature", last.curvature);
          archive.write_number(name() + "/moment", last.moment);
          archive.write_number(name() + "/matrix moment", last.matrix_moment);
        }
    }



    void
    FabricSupports::load(const ArchiveReader &archive,
                         const System::State &state)
    {
      Supports::load(archive, state);
      find_sides(state);
      for (unsigned int i = 0; i < n_directions; ++i)
        {
          const std::string begin = name() + "/" + direction_names[i];
          last.length[i]          = archive.read_number(begin + " length");
          last.force[i]           = archive.read_number(begin + " force");
          last.matrix_force[i] = archive.read_number(begin + " matrix force");
        }
      last.angle  = archive.read_number(name() + "/shear angle");
      last.couple = archive.read_number(name() + "/shear couple");
      if (test.bending)
        {
          origin[2]          = archive.read_number(name() + "/origin z");
          last.curvature     = archive.read_number(name() + "/curvature");
          last.moment        = archive.read_number(name() + "/moment");
          last.matrix_moment = archive.read_number(name() + "/matrix moment");
        }
    }
  } // namespace Contributions
} // namespace Heddle
