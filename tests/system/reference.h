#ifndef heddle_tests_system_reference_h
#define heddle_tests_system_reference_h

#include "composite.h"

/** What the system is to do, with dense matrices and all blocks in a row. */
class Reference
{
public:
  Reference(const Composite                       &scene,
            const std::vector<System::Constraint> &constraints)
    : scene(scene)
    , constraints(constraints)
  {
  }

  /** From space into the frames. */
  Vectors
  in_frames(Vectors values) const
  {
    for (const System::Constraint &constraint : constraints)
      values[constraint.block] = constraint.frame * values[constraint.block];
    return values;
  }

  Vectors
  in_space(Vectors values) const
  {
    for (const System::Constraint &constraint : constraints)
      values[constraint.block] =
        transpose(constraint.frame) * values[constraint.block];
    return values;
  }

  /** Values in the frames with value(constraint, d) where they are fixed. */
  template <typename Value>
  Vectors
  with_fixed(Vectors values, const Value &value) const
  {
    for (const System::Constraint &constraint : constraints)
      for (unsigned int d = 0; d < 3; ++d)
        if (constraint.fixed[d])
          values[constraint.block][d] = value(constraint, d);
    return values;
  }

  Vectors
  without_fixed(const Vectors &values) const
  {
    return with_fixed(values,
                      [](const auto &, const unsigned int) { return 0.; });
  }

  /** With the prescribed motion u. */
  Vectors
  with_pending(const Vectors &values) const
  {
    return with_fixed(values, [](const auto &constraint, const unsigned int d) {
      return constraint.pending[d];
    });
  }

  /** A x of vectors in space. */
  Vectors
  raised(const System::BlockSystem::Part part, const Vectors &motion) const
  {
    const RandomTerms &terms = scene.terms;
    Vectors            forces(motion.size());
    for (unsigned int i = 0; i < 3 * motion.size(); ++i)
      for (unsigned int j = 0; j < 3 * motion.size(); ++j)
        forces[i / 3][i % 3] +=
          (terms.symmetric(i, j) + (part == System::BlockSystem::Part::whole
                                      ? terms.unsymmetric(i, j)
                                      : 0.)) *
          motion[j / 3][j % 3];
    return forces;
  }

  /**
   * The tangent times @p x in the frames Q, Q A Q^T without what is fixed,
   * which has rows of its own.
   */
  Vectors
  product(const System::BlockSystem::Part part, const Vectors &x) const
  {
    return with_fixed(in_frames(raised(part, in_space(without_fixed(x)))),
                      [&](const auto &constraint, const unsigned int d) {
                        return scene.held_stiffness(constraint.block) *
                               x[constraint.block][d];
                      });
  }

  /** -Q (f + A u) where nothing is fixed. */
  Vectors
  right_hand_side() const
  {
    const Vectors motion = in_space(with_pending(Vectors(scene.local.size())));
    Vectors       balancing = raised(System::BlockSystem::Part::whole, motion);
    for (unsigned int b = 0; b < balancing.size(); ++b)
      balancing[b] = -scene.terms.forces[b] - balancing[b];
    return without_fixed(in_frames(balancing));
  }

private:
  const Composite                       &scene;
  const std::vector<System::Constraint> &constraints;
};

#endif
