#ifndef heddle_contributions_fiber_contact_h
#define heddle_contributions_fiber_contact_h

#include <heddle/contact/contact_cells.h>
#include <heddle/contact/contact_parameters.h>
#include <heddle/contributions/indentation.h>
#include <heddle/contributions/searched_fibers.h>
#include <heddle/system/nonsmooth_contribution.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /**
     * Contact of fibers with each other and with themselves, without friction.
     *
     * Search: candidates within the search distance are grouped into proximity
     * zones, which are covered with contact cells. That is repeated when
     * SearchedFibers are stale. Elements are placed anew in the cells whenever
     * the configuration changes.
     *
     * Every rank holds the cells of all pairs with one of its own fibers.
     */
    class FiberContact : public System::NonsmoothContribution
    {
    public:
      FiberContact(const System::FiberSpace         &space,
                   const Contact::ContactParameters &parameters);

      std::string
      name() const override
      {
        return "fiber contact";
      }

      /** From now on leave out pairs for which @p filter is false. */
      void
      restrict_to(const Contact::ContactCells::Filter &filter);

      /**
       * Every step begins with a search, so that what it finds depends on the
       * configuration and the penalties alone.
       */
      void
      begin_step(System::State &state) override;

      void
      update(System::State &state) override;

      void
      begin_iteration(System::State &state) override;

      void
      update_trial(System::State &state) override;

      bool
      needs_new_pattern() const override;

      void
      add_pattern(const System::State  &state,
                  System::BlockPattern &pattern) override;

      void
      assemble(const System::State &state,
               System::BlockSystem &system) override;

      void
      set_softness(const double value) override
      {
        softness = value;
        placed   = false;
      }

      void
      set_geometric_stiffness(const bool wanted) override
      {
        forces_turn = wanted;
      }

      /** Nothing is nonsmooth as long as no fibers come near each other. */
      bool
      is_nonsmooth() const override
      {
        return statistics.n_watched > 0.;
      }

      bool
      is_credible() const override;

      std::pair<double, double>
      slope_and_curvature(const System::State     &state,
                          const System::Increment &increment) const override;

      double
      searched_step(const System::State     &state,
                    const System::Increment &increment) const override
      {
        return statistics.n_watched == 0. && fibers.hold_all()
                 ? fibers.clear_step(state, increment)
                 : fibers.searched_step(state, increment, thickness);
      }

      bool
      adapt(const System::State &state) override;

      /** Those that touch it within an element's length of the node. */
      std::vector<unsigned int>
      contacting_fibers(const unsigned int f,
                        const unsigned int node) const override;

      std::string
      objection(const System::State &state) const override;

      /**
       * Which fibers are deeper in each other than the threshold although no
       * contact is stiffer than theirs, or nothing.
       * @note Collective.
       */
      std::string
      jam_in_words() const;

      /**
       * The mean force of a contact now, at least a hundredth of the largest
       * one that there was in this stage: where fibers come to rest forces that
       * vanish are no measure.
       */
      double
      typical_force() const override
      {
        return std::max(statistics.mean_force, 0.01 * largest_mean_force);
      }

      /** Others may have made a pattern meanwhile. */
      void
      begin_stage(const System::State &) override
      {
        largest_mean_force = 0.;
        pattern_covers_all = false;
      }

      std::string
      status() const override;

      void
      report(const System::State           &state,
             std::map<std::string, double> &values) const override;

      void
      accept_step(const System::State &state) override;

      /** Penalties that a step raised in vain are taken back. */
      void
      reject_step(System::State &state) override;

      /** The cells of all zones, with their penalties. */
      void
      save(ArchiveWriter &archive, const System::State &state) const override;

      void
      load(const ArchiveReader &archive, const System::State &state) override;

      void
      load_initial(const ArchiveReader &archive,
                   const System::State &state) override
      {
        if (archive.has(name() + "/cells"))
          load(archive, state);
        else
          forget();
      }

      /** As if fibers had never touched. */
      void
      forget();

      const std::vector<Contact::ContactElement> &
      elements() const
      {
        return contact_elements;
      }

      /** Elements are others, or elsewhere, when this is another number. */
      unsigned int
      placement() const
      {
        return n_placements;
      }

      /** The centerlines on which the elements lie. */
      const Contact::CurveList &
      curves() const
      {
        return fibers.curves();
      }

      /** Of the last accepted step. */
      const Indentation &
      indentation() const
      {
        return indented;
      }

      /** Derivative of an element's force by its penetration [N/mm]. */
      double
      stiffness(const Contact::ContactElement &element) const;

      /**
       * The fibers as they lie in @p state are free of contact forces from now
       * on, see ContactCells::forgive(). Energy counts from zero.
       * @note Collective.
       */
      void
      forgive_penetration(System::State &state);

      /** Set the threshold that adapt() and objection() go by [-]. */
      void
      set_threshold(const double value);

    private:
      /** Over all ranks, of the elements as last placed. */
      struct Statistics
      {
        double n_watched       = 0.; /**< cells */
        double n_active        = 0.; /**< cells in which fibers touch */
        double mean_force      = 0.; /**< of such a cell [N] */
        double deepest         = 0.; /**< largest penetration over radius [-] */
        double least_penalty   = 0.;
        double largest_penalty = 0.;
        double energy          = 0.; /**< [N mm] */
      };

      void
      search(System::State &state);

      /** Unless they are already as they have to be. */
      void
      place_elements(const System::State &state);

      void
      gather_statistics();

      /** From the local elasticity of two parallel fibers [N/mm^2]. */
      double
      first_penalty(const unsigned int a, const unsigned int b) const;

      Contact::NormalLaw
      law(const Contact::ContactElement &element) const;

      /** As the normal law takes it [mm]. */
      double
      penetration(const Contact::ContactElement &element) const;

      /** [N mm] */
      double
      energy(const Contact::ContactElement &element) const;

      /**
       * What penalties brought in by growing since the last accepted step, of
       * which this is the end [N mm].
       * @note Collective.
       */
      double
      energy_of_hardening();

      /** Of the force by the motion of one particle, the other at rest [N/mm].
       */
      SymmetricTensor<2, 3>
      tangent(const Contact::ContactElement &element) const;

      /** Local blocks of the particles of an element and their weights. */
      void
      locate(const System::State            &state,
             const Contact::ContactElement  &element,
             System::AxisCouplings::Blocks  &blocks,
             System::AxisCouplings::Weights &weights) const;

      /** The blocks of elements between the middles of two intervals. */
      System::AxisCouplings::Blocks
      locate_middles(const System::State          &state,
                     const Contact::CandidatePair &pair) const;

      const System::FiberSpace &space;
      const double              refinement;
      double                    threshold;
      const double              largest_radius;
      double                    softness    = 0.;
      bool                      forces_turn = false;

      /** Energy that penalties have brought by growing [N mm]. */
      double hardening = 0.;

      /** Of two fibers, the smaller number first, on each other [N]. */
      using Force = std::pair<std::pair<unsigned int, unsigned int>, double>;

      /** At the last accepted step, of pairs of this rank that touch, sorted.
       */
      std::vector<Force> accepted_forces;

      /** Over the accepted steps of this stage [N]. */
      double largest_mean_force = 0.;

      Contact::ContactCells::Filter filter;

      SearchedFibers                       fibers;
      Contact::ContactCells                cells;
      std::vector<Contact::ContactCell>    accepted_cells;
      double                               accepted_active = 0.;
      std::vector<Contact::ContactElement> contact_elements;
      std::vector<double> thickness; /**< by fiber, see SearchedFibers [mm] */
      Statistics          statistics;
      Indentation         indented;

      /** Largest penetration over radius, an iteration ago [-]. */
      double deepest_before = 0.;

      /** Whether elements are still as the cells say, in this configuration. */
      bool                      placed = false;
      std::vector<Tensor<1, 3>> placed_at;
      unsigned int              n_placements = 0;

      /** Pairs of fiber intervals that the pattern of the tangent covers. */
      std::vector<Contact::CandidatePair> pattern_pairs;

      /** Whether it has what couples the blocks of any interval, and no pairs.
       */
      bool pattern_covers_all = false;
    };
  } // namespace Contributions
} // namespace Heddle

#endif
