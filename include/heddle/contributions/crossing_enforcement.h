#ifndef heddle_contributions_crossing_enforcement_h
#define heddle_contributions_crossing_enforcement_h

#include <heddle/contact/broad_phase.h>
#include <heddle/contact/normal_law.h>
#include <heddle/contact/projected_crossing.h>
#include <heddle/contributions/centerlines.h>
#include <heddle/system/nonsmooth_contribution.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /** Two yarns that cross, by their yarn_id, in the order of the pattern. */
    struct OrderedYarns
    {
      unsigned int upper, lower;
    };



    /**
     * Contact of an enforced direction between the fibers of crossing yarns,
     * which brings yarns that run through each other onto their sides.
     *
     * For each upper and lower fiber the particles are those whose projections
     * on the plane of the fabric coincide. The gap is counted along z,
     * @f[ g = z_u - z_l - c (R_u + R_l) + a, @f]
     * where c >= 1 is what fibers that climb need to be as far apart as level
     * ones, from their slopes when the step began, and a is an allowance, to be
     * lowered step by step from the initial overlap to zero or below. So only
     * the few layers of the two yarns that are next to each other touch at a
     * time, and each step is a small one.
     *
     * The derivative of g is $n \cdot (\delta x_u - \delta x_l)$, exactly, with
     * the normal n of both fibers at the crossing, scaled to $n_z = 1$: the
     * particles move, but only along the fibers. The tangent leaves out the
     * second derivative of g, which is zero for motion along z.
     *
     * @note The state must hold all fibers that cross own ones, whole.
     */
    class CrossingEnforcement : public System::NonsmoothContribution
    {
    public:
      CrossingEnforcement(const System::FiberSpace        &space,
                          const std::vector<OrderedYarns> &crossings);

      std::string
      name() const override
      {
        return "crossing enforcement";
      }

      /** What the surfaces may overlap along z; negative: a distance [mm]. */
      void
      set_allowance(const double value)
      {
        allowance = value;
      }

      /**
       * Largest overlap along z of two fibers in the order of the pattern: the
       * least allowance at which nothing touches [mm].
       * @note Collective.
       */
      double
      largest_overlap(System::State &state);

      /** Whether the order of these two fibers is enforced. */
      bool
      enforces(const unsigned int a, const unsigned int b) const;

      /** Enforce nothing any more, and report nothing. */
      void
      end();

      void
      begin_step(System::State &state) override;

      void
      update(System::State &state) override;

      void
      update_trial(System::State &state) override
      {
        place_elements(state);
      }

      bool
      needs_new_pattern() const override;

      void
      add_pattern(const System::State  &state,
                  System::BlockPattern &pattern) override;

      void
      assemble(const System::State &state,
               System::BlockSystem &system) override;

      std::pair<double, double>
      slope_and_curvature(const System::State     &state,
                          const System::Increment &increment) const override;

      double
      typical_force() const override
      {
        return mean_force;
      }

      std::string
      status() const override;

      void
      report(const System::State           &state,
             std::map<std::string, double> &values) const override;

    private:
      /** Two fibers and where they were last found to cross. */
      struct Pair
      {
        unsigned int               upper, lower;
        Contact::ProjectedCrossing crossing;
        double                     climb = 1.; /**< c [-] */
      };

      /** Two particles that overlap. */
      struct Element
      {
        Contact::CandidatePair      intervals;
        std::array<unsigned int, 8> blocks;    /**< local ones */
        std::array<Tensor<1, 3>, 8> direction; /**< of the gap in the blocks */
        double                      penetration; /**< [mm] */
        double                      penalty;     /**< times its length [N/mm] */
        Contact::NormalLaw          law;
        bool                        own; /**< counted by this rank */

        double
        force() const
        {
          return law.pressure(penalty, penetration);
        }

        double
        stiffness() const
        {
          return law.stiffness(penalty, penetration);
        }
      };

      /** Whether the pattern has fiber @p a above fiber @p b. */
      bool
      puts_above(const unsigned int a, const unsigned int b) const;

      void
      place_elements(const System::State &state);

      /** Overlap of a pair without allowance; negative if apart [mm]. */
      double
      overlap(Pair &pair) const;

      Element
      make_element(const System::State &state,
                   const Pair          &pair,
                   const double         penetration) const;

      void
      gather_statistics();

      std::vector<Contact::CandidatePair>
      intervals() const;

      const System::FiberSpace                          &space;
      std::vector<std::pair<unsigned int, unsigned int>> enforced_yarns;
      double                                             allowance = 0.;

      std::vector<Pair>                   pairs;
      std::vector<Element>                elements;
      std::vector<Contact::CandidatePair> pattern_intervals;

      Centerlines centerlines;

      /** Over all ranks. */
      double n_overlapping = 0., mean_force = 0., energy = 0., deepest = 0.;
    };
  } // namespace Contributions
} // namespace Heddle

#endif
