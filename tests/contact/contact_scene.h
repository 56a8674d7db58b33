#ifndef heddle_tests_contact_contact_scene_h
#define heddle_tests_contact_contact_scene_h

#include <heddle/base/choice.h>
#include <heddle/contributions/fiber_contact.h>

#include "knots.h"

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

/** Fibers of radius 1 and modulus 1 on given paths, and their contact. */
class ContactScene
{
public:
  struct Options
  {
    std::string  element    = "hermite";
    unsigned int degree     = 1;
    double       refinement = 1.;
    double       threshold  = 0.02;
  };

  ContactScene(const std::vector<Path>         &paths,
               const std::vector<unsigned int> &n_intervals,
               const Options                   &options)
    : space(MPI_COMM_WORLD,
            Heddle::Beam::make_element(
              Heddle::choice<Heddle::Beam::ElementKind>(options.element),
              options.degree),
            describe(paths, n_intervals, options))
    , state(space)
  {
    parameters.threshold  = options.threshold;
    parameters.refinement = options.refinement;
    contact =
      std::make_unique<Heddle::Contributions::FiberContact>(space, parameters);
    for (unsigned int f = 0; f < paths.size(); ++f)
      set_path(f, paths[f], n_intervals[f]);
  }

  ContactScene(const std::vector<Path>         &paths,
               const std::vector<unsigned int> &n_intervals)
    : ContactScene(paths, n_intervals, Options())
  {
  }

  /** Put fiber @p f on another path; its reference lengths stay. */
  void
  set_path(const unsigned int f, const Path &path, const unsigned int n)
  {
    if (!space.owns(f))
      return;
    const Knots    knots(path, n);
    Tensor<1, 3>  *blocks   = state.fiber(f);
    const unsigned per_node = space.n_blocks_per_node();
    for (unsigned int i = 0; i <= n; ++i)
      {
        const Tensor<1, 3> t = knots.tangents[i];
        blocks[per_node * i] = knots.positions[i];
        if (per_node == 2)
          blocks[per_node * i + 1] = t;
        else
          {
            Tensor<1, 3> other;
            other[std::abs(t[0]) < 0.7 ? 0 : 1] = 1.;
            const Tensor<1, 3> g                = cross_product_3d(t, other);
            blocks[per_node * i + 1]            = g / g.norm();
            blocks[per_node * i + 2] = cross_product_3d(t, g / g.norm());
          }
      }
  }

  /** Detect anew if needed, and return internal forces on the own blocks. */
  const std::vector<Tensor<1, 3>> &
  forces(const bool search = false)
  {
    if (search)
      contact->begin_step(state);
    contact->update(state);
    return assemble();
  }

  /** The forces of the contact elements as they are. */
  const std::vector<Tensor<1, 3>> &
  assemble()
  {
    using Heddle::System::BlockSystem;
    system = std::make_unique<BlockSystem>(state);
    system->begin(BlockSystem::Want::residual);
    contact->assemble(state, *system);
    return system->residual();
  }

  /** The tangent times a motion of all blocks, on one rank. */
  std::vector<Tensor<1, 3>>
  tangent_times(const std::vector<Tensor<1, 3>> &motion)
  {
    using Heddle::System::BlockSystem;
    contact->update(state);
    system = std::make_unique<BlockSystem>(state);
    Heddle::System::BlockPattern pattern(state.n_owned_blocks());
    contact->add_pattern(state, pattern);
    system->set_pattern(pattern);
    system->set_constraints({});
    system->begin(BlockSystem::Want::residual_and_tangent);
    contact->assemble(state, *system);
    system->end();
    return times(*system, motion);
  }

  /** The assembled tangent of @p system times a motion, on one rank. */
  static std::vector<Tensor<1, 3>>
  times(const Heddle::System::BlockSystem &system,
        const std::vector<Tensor<1, 3>>   &motion)
  {
    for (unsigned int b = 0; b < motion.size(); ++b)
      for (unsigned int d = 0; d < 3; ++d)
        VecSetValue(system.solution(), 3 * b + d, motion[b][d], INSERT_VALUES);
    VecAssemblyBegin(system.solution());
    VecAssemblyEnd(system.solution());
    MatMult(system.tangent(), system.solution(), system.right_hand_side());
    std::vector<Tensor<1, 3>> result(motion.size());
    const double             *values;
    VecGetArrayRead(system.right_hand_side(), &values);
    for (unsigned int b = 0; b < motion.size(); ++b)
      for (unsigned int d = 0; d < 3; ++d)
        result[b][d] = values[3 * b + d];
    VecRestoreArrayRead(system.right_hand_side(), &values);
    return result;
  }

  /** Sum of the contact forces that act on an own fiber [N]. */
  Tensor<1, 3>
  force_on(const unsigned int f) const
  {
    Tensor<1, 3> sum;
    for (unsigned int i = 0; i < space.fiber(f).n_nodes; ++i)
      sum -=
        system
          ->residual()[state.local_block(f) + i * space.n_blocks_per_node()];
    return sum;
  }

  double
  reported(const std::string &name) const
  {
    std::map<std::string, double> values;
    contact->report(state, values);
    return values.at(name);
  }

  double
  energy() const
  {
    return reported("contact_energy[N*mm]");
  }

  Heddle::Contact::ContactParameters                   parameters;
  Heddle::System::FiberSpace                           space;
  Heddle::System::State                                state;
  std::unique_ptr<Heddle::Contributions::FiberContact> contact;
  std::unique_ptr<Heddle::System::BlockSystem>         system;

private:
  static std::vector<Heddle::System::FiberSpace::Description>
  describe(const std::vector<Path>         &paths,
           const std::vector<unsigned int> &n_intervals,
           const Options                   &options)
  {
    const unsigned int per_element =
      options.element == "hermite" ? 1 : options.degree;
    std::vector<Heddle::System::FiberSpace::Description> result;
    for (unsigned int f = 0; f < paths.size(); ++f)
      {
        const Knots                             knots(paths[f], n_intervals[f]);
        Heddle::System::FiberSpace::Description fiber;
        for (unsigned int i = 0; i < n_intervals[f]; i += per_element)
          fiber.element_lengths.push_back(knots.arc_lengths[i + per_element] -
                                          knots.arc_lengths[i]);
        fiber.radius    = 1.;
        fiber.yarn_id   = f;
        fiber.bundle_id = f;
        fiber.section   = Heddle::Beam::circular_section(1., 1., 0.4, 0.25);
        result.push_back(fiber);
      }
    return result;
  }
};

#endif
