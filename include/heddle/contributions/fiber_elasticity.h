#ifndef heddle_contributions_fiber_elasticity_h
#define heddle_contributions_fiber_elasticity_h

#include <heddle/system/contribution.h>

#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /**
     * Elastic forces of the owned fibers, and the stress-free reference from
     * which their strains are counted.
     */
    class FiberElasticity : public System::Contribution
    {
    public:
      /**
       * The fibers are free of stress in the configuration @p reference, the
       * owned blocks of a State.
       */
      FiberElasticity(const System::FiberSpace        &space,
                      const std::vector<Tensor<1, 3>> &reference);

      std::string
      name() const override
      {
        return "fiber elasticity";
      }

      void
      begin_step(System::State &state) override;

      void
      add_pattern(const System::State  &state,
                  System::BlockPattern &pattern) override;

      void
      assemble(const System::State &state,
               System::BlockSystem &system) override;

      void
      predict(const System::State     &state,
              const System::Increment &increment) override;

      /**
       * E A / h along a fiber, and across it, where sections stay normal to the
       * axis, 12 E I / h^3, with the distance h of nodes.
       */
      void
      raise_stiffness(System::NodeStiffness &stiffness) const override;

      /** No two nodes next to each other pass by each other. */
      double
      largest_step(const System::State     &state,
                   const System::Increment &increment) const override;

      /**
       * An element that is turned back on itself, in which the law may have no
       * strains, or compressed beyond all that a fiber bears.
       */
      std::string
      objection(const System::State &state) const override;

      void
      report(const System::State           &state,
             std::map<std::string, double> &values) const override;

      /** From now on the fibers are free of stress as they lie in @p state. */
      void
      set_reference(const System::State &state);

      /** The reference, if set_reference() was called. */
      void
      save(ArchiveWriter &archive, const System::State &state) const override;

      void
      load(const ArchiveReader &archive, const System::State &state) override;

      /** The reference is the one of before set_reference(). */
      void
      load_initial(const ArchiveReader &archive,
                   const System::State &state) override;

      /** Reference strains of element @p e of the owned fiber @p f. */
      const double *
      reference_strains(const unsigned int f, const unsigned int e) const
      {
        return reference.data() + offset(f, e);
      }

    private:
      std::size_t
      offset(const unsigned int f, const unsigned int e) const
      {
        return (first_element[f - space.owned_fibers().first] + e) *
               space.element().n_strains();
      }

      /** The reference is about to be another one. */
      void
      keep_first_reference();

      /** Numbers of all elements, and of those of lower ranks. */
      std::pair<unsigned int, unsigned int>
      count_elements() const;

      /** Call @p action(fiber, element, first local block) for owned ones. */
      template <typename Action>
      void
      for_each_element(const System::State &state, const Action &action) const;

      const System::FiberSpace &space;
      std::vector<unsigned int> first_element;
      std::vector<double>       reference;
      std::vector<double>       first_reference; /**< if it was set since */
      bool                      reference_was_set = false;

      /** Predicted stresses; not used before the first prediction of a step. */
      std::vector<double> stresses;
      bool                predicted = false;
    };
  } // namespace Contributions
} // namespace Heddle

#endif
