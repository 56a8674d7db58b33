#ifndef heddle_contributions_fiber_friction_h
#define heddle_contributions_fiber_friction_h

#include <heddle/contact/friction_law.h>
#include <heddle/contact/friction_memory.h>
#include <heddle/contributions/fiber_contact.h>
#include <heddle/contributions/friction_coefficients.h>
#include <heddle/contributions/friction_element.h>
#include <heddle/contributions/summed_terms.h>

#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /**
     * Coulomb friction between fibers that touch, with a reversible
     * displacement before slip.
     *
     * A friction element joins two material particles that face each other. Its
     * displacement is the one that the last step left, turned along with the
     * fibers, plus what the particles moved against each other since, without
     * the rotation of both. Where the element has sections the particles lie on
     * the surfaces: friction bends, twists and rolls. The torsion-free element
     * has particles on its axis, and the rotation of the pair stands for that
     * of the sections: friction bends, and fibers side by side roll over each
     * other for nothing.
     *
     * Elements are placed anew with those of contact, whenever the
     * configuration changes: what is found to be in equilibrium is so for the
     * normal forces that it has. The symmetric part of the tangent leaves out
     * that these change; the unsymmetric terms say it.
     */
    class FiberFriction : public System::NonsmoothContribution
    {
    public:
      /** @p contact is updated before this is, and outlives it. */
      FiberFriction(const System::FiberSpace         &space,
                    const Contact::ContactParameters &parameters,
                    const FiberContact               &contact);

      std::string
      name() const override
      {
        return "fiber friction";
      }

      void
      update(System::State &state) override;

      /** Contact may have raised its penalties. */
      void
      begin_iteration(System::State &state) override
      {
        place_elements(state);
      }

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

      bool
      is_nonsmooth() const override
      {
        return contact.is_nonsmooth();
      }

      std::pair<double, double>
      slope_and_curvature(const System::State     &state,
                          const System::Increment &increment) const override;

      void
      report(const System::State           &state,
             std::map<std::string, double> &values) const override;

      void
      accept_step(const System::State &state) override;

      /**
       * What it does at each element of the contact from which its own were
       * placed, none where nothing touches or rubs.
       */
      std::vector<Contact::TangentialForce>
      tangential_forces(const System::State &state) const;

      /** Nothing was displaced or dissipated yet. */
      void
      forget();

      /** Whether fibers rub from now on; the same on all ranks. */
      void
      set_active(const bool yes);

      /** What is remembered, and the energies. */
      void
      save(ArchiveWriter &archive, const System::State &state) const override;

      void
      load(const ArchiveReader &archive, const System::State &state) override;

      /** Others may have made a pattern meanwhile. */
      void
      begin_stage(const System::State &) override
      {
        pattern_covers_all = false;
        pattern_pairs.clear();
      }

      void
      load_initial(const ArchiveReader &archive,
                   const System::State &state) override
      {
        if (archive.has(name() + "/displacements"))
          load(archive, state);
        else
          forget();
      }

    private:
      /** Where fibers rub, and how strongly. */
      struct Element : public FrictionElement
      {
        using FrictionElement::FrictionElement;

        Contact::FrictionLaw law;

        /** Energy that the last step left, over the limit [mm]. */
        double energy_before;

        double limit_before; /**< mu f that the last step left there [N] */

        /** How the limit falls while the gap opens [N/mm]. */
        double limit_stiffness;
      };

      /** Take particles, normals and forces from the contact as it is. */
      void
      place_elements(const System::State &state);

      /**
       * Components of the force of friction along the fibers and across, and,
       * if wanted, of its derivative by those of the displacement.
       */
      struct Response
      {
        Tensor<1, 3>          displacement;         /**< [mm] */
        std::array<double, 2> force;                /**< [N] */
        double                along, mixed, across; /**< of 2 x 2 [N/mm] */
      };

      Response
      respond(const System::State &state,
              const Element       &element,
              const bool           with_stiffness) const;

      /** Have room for what all elements add to the tangent. */
      void
      reserve(System::BlockSystem &system) const;

      /** Add an element to @p terms, of residual and matrix. */
      void
      add(const Element  &element,
          const Response &response,
          SummedTerms    &terms) const;

      /**
       * Add what acts on both fibers one by one to @p of_a and @p of_b, and
       * what couples them to the section_couplings() of @p system.
       */
      void
      add_apart(const Element       &element,
                const Response      &response,
                SummedTerms         &of_a,
                SummedTerms         &of_b,
                System::BlockSystem &system) const;

      /**
       * Add how the force of @p element, with the displacement @p u, follows
       * the normal force.
       */
      void
      add_change_of_limit(const Element            &element,
                          const Tensor<1, 3>       &u,
                          System::UnsymmetricTerms &terms) const;

      Element
      make_element(const System::State           &state,
                   const Contact::ContactElement &touching) const;

      /** Part of the step during which the fibers touched [-]. */
      double
      share_of_step(const Contact::ContactElement &touching,
                    const FrictionElement::Motion &motion) const;

      /**
       * Limits of all elements that the last step left [N]: those of their
       * particles, so that their sum over both fibers is what it was. What
       * these had elsewhere, as where one slides by more than the length of a
       * contact, is shared out as the present limits are.
       */
      std::vector<double>
      limits_before() const;

      const System::FiberSpace         &space;
      const Contact::ContactParameters &parameters;
      const FiberContact               &contact;
      const FrictionCoefficients        coefficients;
      Contact::FrictionMemory           memory;
      std::vector<Element>              elements;

      bool active = true;

      /** That of contact from which they were made; 0: make them anew. */
      unsigned int placement = 0;

      /** Pairs of fiber intervals that the pattern of the tangent covers. */
      std::vector<Contact::CandidatePair> pattern_pairs;

      /** Whether it has what couples the blocks of any interval, and no pairs.
       */
      bool         pattern_covers_all = false;
      unsigned int ghost_version      = 0;
      double       stored             = 0.; /**< [N mm] */
      double       dissipated         = 0.; /**< [N mm] */
    };
  } // namespace Contributions
} // namespace Heddle

#endif
