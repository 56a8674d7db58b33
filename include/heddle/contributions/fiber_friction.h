#ifndef heddle_contributions_fiber_friction_h
#define heddle_contributions_fiber_friction_h

#include <heddle/contact/friction_law.h>
#include <heddle/contact/friction_memory.h>
#include <heddle/contributions/fiber_contact.h>
#include <heddle/contributions/friction_coefficients.h>

#include <array>
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
     * normal forces that it has. The tangent leaves out that these change; it
     * stays symmetric.
     */
    class FiberFriction : public System::Contribution
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

      void
      probe(System::State &state) override;

      bool
      needs_new_pattern() const override;

      void
      add_pattern(const System::State          &state,
                  System::BlockSystem::Pattern &pattern) override;

      void
      assemble(const System::State &state,
               System::BlockSystem &system) override;

      bool
      is_rough() const override
      {
        return contact.is_rough();
      }

      std::pair<double, double>
      slope_and_curvature(const System::State     &state,
                          const System::Increment &increment) const override;

      void
      report(const System::State           &state,
             std::map<std::string, double> &values) const override;

      void
      accept_step(const System::State &state) override;

      /** What is remembered, and the energies. */
      void
      save(ArchiveWriter &archive) const override;

      void
      load(const ArchiveReader &archive) override;

    private:
      /** Two particles that rub against each other. */
      struct Element
      {
        unsigned int         fiber_a, fiber_b;
        int                  orientation;
        double               s_a, s_b; /**< [mm] */
        double               weight;   /**< [mm] */
        Tensor<1, 3>         normal;
        Contact::FrictionLaw law;

        /** Section coordinates of the particles, where there are any [mm]. */
        std::array<double, 2> place_a, place_b;

        /** Part of the step during which the fibers touched [-]. */
        double share;

        /**
         * Directions of the plane of contact, along the fibers and across, and
         * how displacements in them grow with the separation of the particles
         * and with the tangents of both fibers [-, -, mm].
         */
        Tensor<1, 3> axes[2];
        Tensor<1, 3> by_separation[2];
        Tensor<1, 3> by_tangent[2][2];

        /** Displacement where all blocks are zero [mm]. */
        Tensor<1, 3> offset;

        /** Energy that the last step left, over the limit [mm]. */
        double energy_before;
      };

      /** How the blocks of both fibers make up the particles' separation. */
      struct Separation
      {
        static constexpr unsigned int max_blocks = 16;

        unsigned int                         n = 0;
        std::array<unsigned int, max_blocks> blocks; /**< local numbers */
        std::array<double, max_blocks>       weights;

        /** Of the tangent of the fiber, where its rotation counts [1/mm]. */
        std::array<double, max_blocks> slopes = {};

        Tensor<1, 3>
        of(const std::vector<Tensor<1, 3>> &values) const;
      };

      /** Derivatives of both components of a displacement by the blocks. */
      struct Derivative
      {
        Derivative(const Element &element, const Separation &separation);

        std::array<std::array<Tensor<1, 3>, Separation::max_blocks>, 2> rows;
      };

      /** Change of the displacement with the motion @p values of blocks. */
      static std::array<double, 2>
      change(const Element                   &element,
             const Separation                &separation,
             const std::vector<Tensor<1, 3>> &values);

      Separation
      separation(const System::State &state, const Element &element) const;

      void
      add_particle(const System::State         &state,
                   const unsigned int           fiber,
                   const double                 s,
                   const std::array<double, 2> &place,
                   const double                 sign,
                   Separation                  &separation) const;

      /** Coordinates in the section of the vector @p r from the axis. */
      std::array<double, 2>
      place_in_section(const System::State &state,
                       const unsigned int   fiber,
                       const double         s,
                       const Tensor<1, 3>  &r) const;

      /** A pair of particles on the axes in some configuration. */
      struct Pair
      {
        Tensor<1, 3> tangent[2];
        Tensor<1, 3> connection; /**< from b to a [mm] */

        Tensor<2, 3>
        frame(const int orientation) const;
      };

      Pair
      pair(const System::State             &state,
           const Element                   &element,
           const std::vector<Tensor<1, 3>> &values) const;

      /** Displacement of an element in the configuration @p values. */
      Tensor<1, 3>
      displacement(const Element                   &element,
                   const Separation                &separation,
                   const std::vector<Tensor<1, 3>> &values) const;

      /** Set axes and displacement, with what the last step left. */
      void
      set_displacement(const System::State           &state,
                       const Contact::ContactElement &touching,
                       const Pair                    &now,
                       Element                       &element) const;

      /**
       * Set how the displacement of @p element grows with the blocks: @p now
       * is the pair, @p arm what is between its particles.
       */
      void
      lean(Element &element, const Pair &now, const Tensor<1, 3> &arm) const;

      /** Take particles, normals and forces from the contact as it is. */
      void
      place_elements(const System::State &state);

      Element
      make_element(const System::State           &state,
                   const Contact::ContactElement &touching) const;

      /** Friction that the last step left, over that of now, of both fibers. */
      std::vector<double>
      limits_before() const;

      const System::FiberSpace         &space;
      const Contact::ContactParameters &parameters;
      const FiberContact               &contact;
      const FrictionCoefficients        coefficients;
      Contact::FrictionMemory           memory;
      std::vector<Element>              elements;
      /** Pairs of fiber intervals that the pattern of the tangent covers. */
      std::vector<Contact::CandidatePair> pattern_pairs;
      unsigned int                        ghost_version = 0;
      double                              stored        = 0.; /**< [N mm] */
      double                              dissipated    = 0.; /**< [N mm] */
    };
  } // namespace Contributions
} // namespace Heddle

#endif
