#ifndef heddle_contributions_loads_h
#define heddle_contributions_loads_h

#include <heddle/base/expression.h>
#include <heddle/contributions/external_work.h>
#include <heddle/contributions/load_parameters.h>
#include <heddle/system/contribution.h>

#include <array>
#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /**
     * Forces, moments and forces per length that keep their direction in space.
     *
     * Forces per length act on the smooth centerline, as contact does. Moments
     * turn the section vectors or the tangent of a node, see
     * Beam::end_moment(); the part of their tangent that is not symmetric is
     * beside the matrix of the system.
     */
    class Loads : public System::Contribution
    {
    public:
      /**
       * @p reference: the owned blocks that x, y and z in formulas refer to,
       * until a stage begins in another configuration: fibers @p will_settle
       * before they are loaded.
       */
      Loads(const System::FiberSpace        &space,
            const std::vector<Tensor<1, 3>> &reference,
            const LoadList                  &loads,
            const bool                       will_settle = false);

      std::string
      name() const override
      {
        return "loads";
      }

      void
      begin_stage(const System::State &state) override;

      /** Throws InputError if a formula has no finite value now. */
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

      double
      typical_force() const override
      {
        return largest_force;
      }

      void
      observe(const System::BlockSystem &system) override;

      /**
       * For each load the sum of its forces, forces per length included, and
       * the mean displacement of its nodes; what all of them have done.
       */
      void
      report(const System::State           &state,
             std::map<std::string, double> &values) const override;

      void
      accept_step(const System::State &state) override;

      /** Where formulas and displacements count from, and the work. */
      void
      save(ArchiveWriter &archive, const System::State &state) const override;

      void
      load(const ArchiveReader &archive, const System::State &state) override;

    private:
      using Expressions = std::array<Expression, 3>;

      /** A force on one owned block that grows with an expression. */
      struct Force
      {
        unsigned int load;
        unsigned int block; /**< local number */
        double       weight;
        Tensor<1, 3> position; /**< reference position of its point [mm] */
        bool         per_length;
      };

      /** A moment on the vectors of one owned node. */
      struct Moment
      {
        unsigned int load;
        unsigned int block;    /**< local number of the first vector */
        double       interval; /**< length of fiber that a node stands for */
        Tensor<1, 3> position;
        Tensor<1, 3> value; /**< [N mm] */
        Tensor<1, 3> predicted;
      };

      /** An owned node whose displacement is reported. */
      struct Watched
      {
        unsigned int load;
        unsigned int block; /**< local number */
        Tensor<1, 3> position;
      };

      /** Find everything that loads act on. */
      void
      place(const std::vector<Tensor<1, 3>> &new_reference,
            const bool                       will_settle = false);

      void
      add_nodes(const unsigned int               load,
                const LoadParameters            &parameters,
                const std::vector<Tensor<1, 3>> &reference,
                const bool                       will_settle);

      void
      add_fibers(const unsigned int               load,
                 const LoadParameters            &parameters,
                 const std::vector<Tensor<1, 3>> &reference);

      static Tensor<1, 3>
      evaluate(const Expressions  &expressions,
               const Tensor<1, 3> &position,
               const double        load_factor);

      /** Forces and moments now, and what forces come to by loads: @p sums. */
      void
      evaluate_all(const double load_factor);

      void
      find_largest_force();

      /** Of the @p derivative of a moment's forces on the block and the next.
       */
      void
      add_skew_part(const unsigned int   block,
                    const double        *derivative,
                    System::BlockSystem &system) const;

      const System::FiberSpace &space;
      const LoadList           &loads;
      const unsigned int        n_vectors; /**< per node: 1 or 2 */
      std::vector<Tensor<1, 3>> reference; /**< owned blocks */
      std::vector<Expressions>  forces_of, moments_of, forces_per_length_of;
      std::vector<unsigned int> n_nodes_of;

      std::vector<Force>   forces;
      std::vector<Moment>  moments;
      std::vector<Watched> watched;

      // Of the step that began last.
      std::vector<Tensor<1, 3>> external; /**< on owned blocks [N] */
      std::vector<Tensor<1, 3>> totals;   /**< by load, over all ranks [N] */
      double                    largest_force = 0.;
      bool                      predicted     = false;
      ExternalWork              work;
    };
  } // namespace Contributions
} // namespace Heddle

#endif
