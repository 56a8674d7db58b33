#ifndef heddle_contributions_supports_h
#define heddle_contributions_supports_h

#include <heddle/base/expression.h>
#include <heddle/contributions/external_work.h>
#include <heddle/contributions/held_block.h>
#include <heddle/contributions/support.h>
#include <heddle/system/contribution.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /**
     * Prescribed motions of nodes and sections, and the forces that they cost.
     *
     * A section is held by its section vectors. The Hermite element has a
     * tangent in their place: only its direction is held, by its two
     * components normal to the direction wanted, so that the fiber may stretch.
     */
    class Supports : public System::Contribution
    {
    public:
      /**
       * Motions are counted from the configuration @p reference, given by its
       * owned blocks, until a stage begins in another one: fibers @p
       * will_settle before they are held.
       * @note Collective. Throws InputError, see find_held_blocks().
       */
      Supports(const System::FiberSpace        &space,
               const std::vector<Tensor<1, 3>> &reference,
               const SupportList               &supports,
               const bool                       will_settle = false);

      std::string
      name() const override
      {
        return "supports";
      }

      void
      begin_stage(const System::State &state) override;

      /** Throws InputError if a formula has no finite value now. */
      void
      begin_step(System::State &state) override;

      void
      constrain(const System::State             &state,
                std::vector<System::Constraint> &constraints) const override;

      void
      assemble(const System::State &, System::BlockSystem &) override
      {
      }

      void
      observe(const System::BlockSystem &system) override;

      /**
       * The sum of the forces by which each support acts, that on the matrix
       * also by itself, their moment about the origin, with that on held
       * sections, and the work of all supports.
       */
      void
      report(const System::State           &state,
             std::map<std::string, double> &values) const override;

      /**
       * Where a node is at a load factor, if all of its position is prescribed
       * [mm]. Throws InputError if a formula has no finite value.
       */
      std::optional<Tensor<1, 3>>
      prescribed_position(const unsigned int f,
                          const unsigned int node,
                          const double       load_factor) const;

      void
      accept_step(const System::State &state) override;

      /** Where motions count from, and the work. */
      void
      save(ArchiveWriter &archive, const System::State &state) const override;

      void
      load(const ArchiveReader &archive, const System::State &state) override;

    protected:
      /** All that is held, on all ranks. */
      const std::vector<HeldBlock> &
      held_blocks() const
      {
        return blocks;
      }

      /** Where formulas count positions from [mm]. */
      Tensor<1, 3> origin;

    private:
      /** The formulas of one support; free components have none. */
      struct Motion
      {
        std::array<std::unique_ptr<Expression>, 3> displacement;
        std::unique_ptr<Expression>                angle;
        Tensor<1, 3>                               axis;
      };

      struct Reaction
      {
        Tensor<1, 3> force;     /**< [N] */
        Tensor<1, 3> moment;    /**< about the origin [N mm] */
        Tensor<1, 3> of_matrix; /**< part of the force on the matrix [N] */
      };

      /** The rotation of the sections that a support holds. */
      Tensor<2, 3>
      rotation(const HeldBlock &held, const double load_factor) const;

      /** What turned since the last step was accepted. */
      std::vector<ExternalWork::Turn>
      turns_of_step(const System::State &state) const;

      /** The component along which the node of a block may slide, if any. */
      std::optional<unsigned int>
      slides_along(const HeldBlock &held) const;

      /** Where the motion takes a block; free components: its reference. */
      Tensor<1, 3>
      target(const HeldBlock &held, const double load_factor) const;

      const System::FiberSpace &space;
      const SupportList        &supports;
      std::vector<Tensor<1, 3>> reference; /**< owned blocks */
      std::vector<HeldBlock>    blocks;
      std::vector<Motion>       motions;
      std::vector<Reaction>     reactions;
      ExternalWork              work;

      /** Of the last step; none yet: nothing is turned [-]. */
      std::optional<double> accepted_load_factor;

      /** Whether the configuration in which a stage begins is accepted next. */
      bool begins_stage = false;
    };
  } // namespace Contributions
} // namespace Heddle

#endif
