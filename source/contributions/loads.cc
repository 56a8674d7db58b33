#include <heddle/base/reduce.h>
#include <heddle/base/throw_together.h>
#include <heddle/beam/end_moment.h>
#include <heddle/beam/section_rotation.h>
#include <heddle/contributions/loads.h>
#include <heddle/system/block_archive.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

namespace Heddle
{
  namespace Contributions
  {
    namespace
    {
      std::array<Expression, 3>
      parse(const LoadParameters             &parameters,
            const std::string                &name,
            const std::array<std::string, 3> &texts)
      {
        const auto component = [&](const unsigned int d) {
          return Expression(texts[d], parameters.entry(name, d));
        };
        return {{component(0), component(1), component(2)}};
      }
    } // namespace



    Loads::Loads(const System::FiberSpace        &space,
                 const std::vector<Tensor<1, 3>> &reference,
                 const LoadList                  &loads,
                 const bool                       will_settle)
      : space(space)
      , loads(loads)
      , n_vectors(space.n_blocks_per_node() - 1)
      , totals(loads.size())
    {
      for (const auto &load : loads)
        {
          forces_of.push_back(parse(*load, "Force", load->force));
          moments_of.push_back(parse(*load, "Moment", load->moment));
          forces_per_length_of.push_back(
            parse(*load, "Force per length", load->force_per_length));
        }
      place(reference, will_settle);

      // As of supports: told before a fabric settles.
      throw_together(
        [&]() {
          for (const double load_factor : {1., 0.})
            evaluate_all(load_factor);
        },
        space.communicator());
    }



    void
    Loads::begin_stage(const System::State &state)
    {
      place({state.current().begin(),
             state.current().begin() + state.n_owned_blocks()});
    }



    void
    Loads::place(const std::vector<Tensor<1, 3>> &new_reference,
                 const bool                       will_settle)
    {
      reference = new_reference;
      external.assign(reference.size(), Tensor<1, 3>());
      n_nodes_of.clear();
      forces.clear();
      moments.clear();
      watched.clear();
      for (unsigned int i = 0; i < loads.size(); ++i)
        {
          add_nodes(i, *loads[i], reference, will_settle);
          if (!is_nothing(loads[i]->force_per_length))
            add_fibers(i, *loads[i], reference);
        }
    }



    void
    Loads::add_nodes(const unsigned int               load,
                     const LoadParameters            &parameters,
                     const std::vector<Tensor<1, 3>> &reference,
                     const bool                       will_settle)
    {
      const std::vector<SelectedNode> nodes = parameters.nodes.find_nodes(
        space, reference, section_in_words(parameters), will_settle);
      n_nodes_of.push_back(nodes.size());
      for (const SelectedNode &node : nodes)
        if (space.owns(node.fiber))
          {
            const System::Fiber &fiber = space.fiber(node.fiber);
            const unsigned int   block = space.first_block(node.fiber) -
                                       space.owned_blocks().first +
                                       node.node * space.n_blocks_per_node();
            const Tensor<1, 3> &position = node.reference[0];
            watched.push_back({load, block, position});
            if (!is_nothing(parameters.force))
              forces.push_back(
                {load, block, 1., position, /*per_length=*/false});
            if (parameters.has_moment())
              moments.push_back({load,
                                 block + 1,
                                 fiber.length / (fiber.n_nodes - 1),
                                 position,
                                 Tensor<1, 3>(),
                                 Tensor<1, 3>()});
          }
    }



    void
    Loads::add_fibers(const unsigned int               load,
                      const LoadParameters            &parameters,
                      const std::vector<Tensor<1, 3>> &reference)
    {
      const QGauss<1> quadrature(3);
      for (const unsigned int f :
           parameters.nodes.find_fibers(space, section_in_words(parameters)))
        if (space.owns(f))
          {
            const unsigned int first =
              space.first_block(f) - space.owned_blocks().first;
            const double *s = space.node_positions(f);
            for (unsigned int i = 0; i + 1 < space.fiber(f).n_nodes; ++i)
              for (unsigned int q = 0; q < quadrature.size(); ++q)
                {
                  const double length = s[i + 1] - s[i];
                  const auto   point =
                    space.locate(f, s[i] + quadrature.point(q)[0] * length);
                  Tensor<1, 3> position;
                  for (unsigned int k = 0; k < 4; ++k)
                    position +=
                      point.values[k] * reference[first + point.blocks[k]];
                  for (unsigned int k = 0; k < 4; ++k)
                    forces.push_back(
                      {load,
                       first + point.blocks[k],
                       quadrature.weight(q) * length * point.values[k],
                       position,
                       /*per_length=*/true});
                }
          }
    }



    Tensor<1, 3>
    Loads::evaluate(const Expressions  &expressions,
                    const Tensor<1, 3> &position,
                    const double        load_factor)
    {
      Tensor<1, 3> vector;
      for (unsigned int d = 0; d < 3; ++d)
        vector[d] = expressions[d].value(position, load_factor);
      return vector;
    }



    void
    Loads::begin_step(System::State &state)
    {
      throw_together([&]() { evaluate_all(state.load_factor); },
                     space.communicator());
      sum_over_ranks(totals, space.communicator());
      predicted = false;
      find_largest_force();
    }



    void
    Loads::evaluate_all(const double load_factor)
    {
      std::fill(totals.begin(), totals.end(), Tensor<1, 3>());
      std::fill(external.begin(), external.end(), Tensor<1, 3>());
      for (const Force &force : forces)
        {
          const Tensor<1, 3> value =
            force.weight * evaluate(force.per_length
                                      ? forces_per_length_of[force.load]
                                      : forces_of[force.load],
                                    force.position,
                                    load_factor);
          external[force.block] += value;
          if (force.block % (n_vectors + 1) == 0)
            totals[force.load] += value;
        }
      for (Moment &moment : moments)
        moment.value =
          evaluate(moments_of[moment.load], moment.position, load_factor);
    }



    void
    Loads::find_largest_force()
    {
      largest_force = 0.;
      for (unsigned int b = 0; b < external.size(); b += n_vectors + 1)
        largest_force = std::max(largest_force, external[b].norm());
      for (const Moment &moment : moments)
        largest_force =
          std::max(largest_force, moment.value.norm() / moment.interval);
      largest_force = Utilities::MPI::max(largest_force, space.communicator());
    }



    void
    Loads::add_pattern(const System::State &, System::BlockPattern &pattern)
    {
      for (const Moment &moment : moments)
        {
          const std::array<unsigned int, 2> blocks = {
            {moment.block, moment.block + 1}};
          pattern.couple(n_vectors, blocks.data());
        }
    }



    void
    Loads::assemble(const System::State &state, System::BlockSystem &system)
    {
      const std::array<double, 9> no_tangent = {};
      for (unsigned int b = 0; b < external.size(); ++b)
        if (external[b] != Tensor<1, 3>())
          {
            const Tensor<1, 3> residual = -external[b];
            system.add(1, &b, residual.begin_raw(), no_tangent.data());
          }

      const unsigned int     n = 3 * n_vectors;
      std::array<double, 6>  force, residual;
      std::array<double, 36> derivative, tangent;
      for (const Moment &moment : moments)
        {
          Beam::end_moment(moment.value,
                           n_vectors,
                           state.current().data() + moment.block,
                           predicted ? &moment.predicted : nullptr,
                           force.data(),
                           derivative.data());
          for (unsigned int i = 0; i < n; ++i)
            {
              residual[i] = -force[i];
              for (unsigned int j = 0; j < n; ++j)
                tangent[n * i + j] =
                  -0.5 * (derivative[n * i + j] + derivative[n * j + i]);
            }
          const std::array<unsigned int, 2> blocks = {
            {moment.block, moment.block + 1}};
          system.add(n_vectors, blocks.data(), residual.data(), tangent.data());
          if (system.wants_tangent())
            add_skew_part(moment.block, derivative.data(), system);
        }
    }



    void
    Loads::add_skew_part(const unsigned int   block,
                         const double        *derivative,
                         System::BlockSystem &system) const
    {
      // Column by column: the motion of one component, and its forces.
      const unsigned int        n     = 3 * n_vectors;
      System::UnsymmetricTerms &terms = system.unsymmetric_terms();
      for (unsigned int j = 0; j < n; ++j)
        {
          Tensor<1, 3> direction;
          direction[j % 3] = 1.;
          terms.begin_term(direction);
          terms.add_motion(block + j / 3, 1.);
          for (unsigned int a = 0; a < n_vectors; ++a)
            {
              Tensor<1, 3> force;
              for (unsigned int d = 0; d < 3; ++d)
                {
                  const unsigned int i = 3 * a + d;
                  force[d] =
                    -0.5 * (derivative[n * i + j] - derivative[n * j + i]);
                }
              terms.begin_force(force);
              terms.add_force(block + a, 1.);
            }
        }
    }



    void
    Loads::predict(const System::State     &state,
                   const System::Increment &increment)
    {
      for (Moment &moment : moments)
        moment.predicted =
          Beam::predict_end_moment(moment.value,
                                   n_vectors,
                                   state.current().data() + moment.block,
                                   increment.data() + moment.block,
                                   predicted ? &moment.predicted : nullptr);
      predicted = true;
    }



    void
    Loads::observe(const System::BlockSystem &system)
    {
      std::vector<Tensor<1, 3>> acting = external;
      std::array<double, 6>     force;
      for (const Moment &moment : moments)
        {
          Beam::end_moment(moment.value,
                           n_vectors,
                           system.state.current().data() + moment.block,
                           nullptr,
                           force.data(),
                           nullptr);
          for (unsigned int i = 0; i < 3 * n_vectors; ++i)
            acting[moment.block + i / 3][i % 3] += force[i];
        }
      work.set_forces(acting);
    }



    void
    Loads::report(const System::State           &state,
                  std::map<std::string, double> &values) const
    {
      std::vector<Tensor<1, 3>> motion(totals.size());
      for (const Watched &node : watched)
        for (unsigned int d = 0; d < 3; ++d)
          motion[node.load][d] +=
            (state.current()[node.block][d] - node.position[d]) /
            n_nodes_of[node.load];
      sum_over_ranks(motion, space.communicator());
      for (unsigned int i = 0; i < totals.size(); ++i)
        for (unsigned int d = 0; d < 3; ++d)
          {
            const std::string load = "load_" + std::to_string(i + 1);
            values[load + "_force_" + "xyz"[d] + "[N]"]         = totals[i][d];
            values[load + "_displacement_" + "xyz"[d] + "[mm]"] = motion[i][d];
          }
      values["external_work[N*mm]"] += work.value();
    }



    void
    Loads::accept_step(const System::State &state)
    {
      std::vector<ExternalWork::Turn> turns;
      for (const Moment &moment : moments)
        {
          const Tensor<1, 3> rotation =
            Beam::section_rotation(n_vectors,
                                   state.accepted().data() + moment.block,
                                   state.current().data() + moment.block);
          for (unsigned int k = 0; k < n_vectors; ++k)
            turns.push_back(
              {moment.block + k, rotation, state.accepted()[moment.block + k]});
        }
      work.add_step(state, turns);
    }



    void
    Loads::save(ArchiveWriter &archive, const System::State &state) const
    {
      System::write_blocks(archive, name() + "/reference", state, reference);
      work.save(archive, name(), state);
    }



    void
    Loads::load(const ArchiveReader &archive, const System::State &state)
    {
      place(System::read_blocks(archive, name() + "/reference", state));
      work.load(archive, name(), state);
    }
  } // namespace Contributions
} // namespace Heddle
