#ifndef heddle_contributions_plates_h
#define heddle_contributions_plates_h

#include <heddle/base/expression.h>
#include <heddle/contact/normal_law.h>
#include <heddle/contributions/plate_parameters.h>
#include <heddle/system/nonsmooth_contribution.h>

#include <deal.II/base/bounding_box.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /**
     * Contact of all fibers with two rigid, smooth plates at $z = z_0$ below
     * and $z = z_1$ above them, which come nearer to each other. Material
     * points of the axes, evenly spaced, are as deep in a plate as
     * @f[ d = R - (z - z_0), \qquad d = R - (z_1 - z), @f]
     * and feel the force per length p(d) of the normal law. Covered are the
     * material points that are below a plate when a stage begins. The penalty
     * of each fiber at each plate grows until it is no deeper than the
     * threshold. d is linear in the unknowns, so that the tangent is exact.
     * Without fibers near a plate this is no term at all, until a step leads
     * them there.
     */
    class Plates : public System::NonsmoothContribution
    {
    public:
      /**
       * @p threshold of penetrations over the radius [-]. If the plates are
       * only @p covered wide, along x and y, their pressure is told [mm].
       */
      Plates(const System::FiberSpace            &space,
             const PlateParameters               &parameters,
             const double                         threshold,
             const std::optional<BoundingBox<2>> &covered);

      std::string
      name() const override
      {
        return "plates";
      }

      /** The plates touch the lowest and the highest surface. */
      void
      begin_stage(const System::State &state) override;

      void
      update(System::State &state) override;

      void
      update_trial(System::State &state) override
      {
        place_points(state);
      }

      /** Whether a fiber is within reach of a plate. */
      bool
      is_nonsmooth() const override
      {
        return reached;
      }

      /** Where none is within reach: to where the first one will be. */
      double
      searched_step(const System::State     &state,
                    const System::Increment &increment) const override;

      void
      add_pattern(const System::State  &state,
                  System::BlockPattern &pattern) override;

      void
      assemble(const System::State &state,
               System::BlockSystem &system) override;

      std::pair<double, double>
      slope_and_curvature(const System::State     &state,
                          const System::Increment &increment) const override;

      /** Not where fibers are deep in a plate, or nearly all of them left it.
       */
      bool
      is_credible() const override;

      void
      set_softness(const double value) override
      {
        softness = value;
      }

      /**
       * Only fibers that are as hard as they are tell how deep they press: soft
       * ones are on their way, and penalties would depend on it.
       */
      bool
      adapt(const System::State &state) override;

      std::string
      objection(const System::State &state) const override;

      /**
       * Mean force where a fiber touches a plate, of a stretch of it, or a
       * hundredth of the largest that it was: forces that vanish are no measure
       * [N].
       */
      double
      typical_force() const override
      {
        return std::max(mean_force(), 0.01 * largest_mean_force);
      }

      std::string
      status() const override;

      void
      report(const System::State           &state,
             std::map<std::string, double> &values) const override;

      void
      accept_step(const System::State &state) override;

      void
      reject_step(System::State &state) override;

      void
      save(ArchiveWriter &archive, const System::State &state) const override;

      void
      load(const ArchiveReader &archive, const System::State &state) override;

      /** Below and above. */
      static constexpr unsigned int n_plates = 2;

      template <typename Value>
      using Both = std::array<Value, n_plates>;

      /** Whether a stage has begun, in which they are somewhere. */
      bool
      are_placed() const
      {
        return begin[1] > begin[0];
      }

      /** Where they are in the last step that was accepted [mm]. */
      const Both<double> &
      heights() const
      {
        return accepted_positions;
      }

      /** What presses on each there [N]. */
      const Both<double> &
      forces() const
      {
        return accepted_force;
      }

      /**
       * What they are drawn over: what they cover or, where that is all, as far
       * as fibers reach now.
       * @note Collective.
       */
      BoundingBox<2>
      extent(const System::State &state) const;

    private:
      /** A material point that is in a plate. */
      struct TouchingPoint
      {
        unsigned int                touch; /**< number of fiber and plate */
        unsigned int                interval;
        std::array<unsigned int, 4> blocks;      /**< local ones */
        std::array<double, 4>       values;      /**< of the axis [-, mm] */
        double                      penetration; /**< [mm] */
        double                      length;      /**< it stands for [mm] */
      };

      /** An own fiber at one plate. */
      struct Touch
      {
        double begin       = 0.; /**< it is covered from here ... [mm] */
        double end         = 0.; /**< ... to here [mm] */
        double penalty     = 0.; /**< [N/mm^2] */
        double hardened    = 1.; /**< by how much it grew in this step */
        double penetration = 0.; /**< deepest [mm] */
        double force       = 0.; /**< [N] */
        double energy      = 0.; /**< [N mm] */
      };

      /** Over all ranks. */
      struct Sums
      {
        Both<double> force       = {}; /**< on each plate [N] */
        double       energy      = 0.; /**< [N mm] */
        double       n_stretches = 0.; /**< where a fiber touches a plate */
      };

      unsigned int
      fiber_of(const unsigned int touch) const
      {
        return space.owned_fibers().first + touch / n_plates;
      }

      /** How deep it is, as the threshold is meant. */
      double
      in_radii(const unsigned int touch) const
      {
        return touches[touch].penetration / space.fiber(fiber_of(touch)).radius;
      }

      /** 1 for the upper plate, -1 for the lower one: outwards along z. */
      static double
      outwards(const unsigned int touch)
      {
        return touch % n_plates == 0 ? -1. : 1.;
      }

      double
      mean_force() const
      {
        return sums.n_stretches > 0.
                 ? (sums.force[0] + sums.force[1]) / sums.n_stretches
                 : 0.;
      }

      Contact::NormalLaw
      law(const unsigned int touch) const;

      double
      force(const TouchingPoint &point) const;

      double
      first_penalty(const unsigned int f) const;

      /** Where the plates are at this load factor [mm]. */
      Both<double>
      positions(const double load_factor) const;

      /** Find which parts of fibers the plates cover now. */
      void
      cover(const System::State &state);

      /** Whether a fiber is within reach of a plate, on any rank. */
      bool
      is_reached(const System::State &state) const;

      /** Call @p action (touch, interval) for the covered ones. */
      template <typename Action>
      void
      for_each_covered(const Action &action) const;

      /** How far @p blocks of a fiber, positions or motions, are outwards at
       * both ends of an interval and at both thirds of it [mm]. */
      std::array<double, 4>
      outwards_along(const Tensor<1, 3> *blocks,
                     const unsigned int  touch,
                     const unsigned int  interval) const;

      /** How deep the fiber is there in this @p plate [mm]. */
      std::array<double, 4>
      depths_along(const System::State &state,
                   const unsigned int   touch,
                   const unsigned int   interval,
                   const double         plate) const;

      /** Fibers over the volume between the plates, where they cover [-]. */
      double
      volume_fraction(const System::State &state) const;

      /** Find the points that are in a plate. */
      void
      place_points(const System::State &state);

      /** Those of one interval of a fiber at one plate. */
      void
      place_points(const System::State &state,
                   const unsigned int   touch,
                   const unsigned int   interval,
                   const double         plate);

      void
      gather_sums();

      /** What growing penalties brought to the energy in this step [N mm]. */
      double
      energy_of_hardening() const;

      const System::FiberSpace           &space;
      const Expression                    compression;
      const double                        threshold; /**< [-] */
      const std::optional<BoundingBox<2>> covered;   /**< [mm] */

      Both<double>       begin = {}; /**< positions at first [mm] */
      std::vector<Touch> touches;    /**< of all own fibers, each at both */
      std::vector<TouchingPoint> points;

      double softness = 0.;   /**< of contact between fibers [-] */
      bool   reached  = true; /**< a fiber is near a plate, on any rank */

      Sums   sums;
      double deepest = 0.; /**< over the radius, over all ranks [-] */

      /** Since the last step that was accepted. */
      std::vector<Touch> accepted_touches;
      Both<double>       accepted_positions = {};
      Both<double>       accepted_force     = {};
      double             accepted_stretches = 0., largest_mean_force = 0.;
      double             work = 0., hardening = 0.; /**< [N mm] */
    };
  } // namespace Contributions
} // namespace Heddle

#endif
