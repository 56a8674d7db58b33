#ifndef heddle_contributions_friction_element_h
#define heddle_contributions_friction_element_h

#include <heddle/contact/contact_element.h>
#include <heddle/system/state.h>

#include <array>
#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /**
     * Two material particles that rub against each other: how their
     * displacement in the plane of contact follows from the blocks of both
     * fibers. It knows neither forces nor what came before the last step.
     *
     * What the blocks are multiplied with stays the same until the element is
     * made anew, and is kept: assembly and line search ask for it many times.
     */
    class FrictionElement
    {
    public:
      /** Of two fibers: four of the axis, four of the section, on each. */
      static constexpr unsigned int max_blocks = 16;

      /** Blocks of the axes, half of them of each fiber. */
      static constexpr unsigned int n_axis_blocks = 8;

      using Blocks  = std::array<unsigned int, max_blocks>;
      using Weights = std::array<double, max_blocks>;

      /** Motion of all blocks that the rank holds, or their configuration. */
      using Values = std::vector<Tensor<1, 3>>;

      /**
       * Take the particles that @p touching has in the current configuration;
       * where there are sections, those on the surfaces in between. Of the
       * displacement nothing is set.
       */
      FrictionElement(const System::State           &state,
                      const Contact::ContactElement &touching);

      /** The pair of particles in some configuration, or its motion. */
      struct Pair
      {
        Tensor<1, 3> tangent[2];
        Tensor<1, 3> connection; /**< of the axes, from b to a [mm] */
        Tensor<1, 3> separation; /**< of the particles [mm] */

        Tensor<2, 3>
        frame(const int orientation) const;
      };

      Pair
      pair(const Values &values) const;

      /** How the pair came from the last step to where it is. */
      struct Motion
      {
        Pair         now;
        Tensor<2, 3> frame;      /**< of the pair now, by its orientation */
        double       cosine;     /**< of the angle between the fibers now [-] */
        double       gap_before; /**< of the surfaces at the last step [mm] */

        double side_on; /**< see side_on() [-] */

        /** In the plane, without the rotation that both fibers share [mm]. */
        Tensor<1, 3> displacement;
      };

      Motion
      motion(const System::State &state) const;

      /**
       * Let the displacement be in the current configuration what was left at
       * the last step, @p left in the frame for @p left_orientation, and the
       * part @p part of the @p motion since, during which it was in contact.
       */
      void
      set_displacement(const Motion       &motion,
                       const double        part,
                       const Tensor<1, 3> &left,
                       const int           left_orientation);

      /** How far particles slide over each other with the blocks, as two
       * components: forces act on what slides. The displacement follows by
       * share(). */
      struct Derivative
      {
        explicit Derivative(const FrictionElement &element);

        /** Three numbers for each block, one after the other. */
        std::array<std::array<double, 3 * max_blocks>, 2> rows;
      };

      /** How far the motion @p values of blocks makes particles slide [mm]. */
      Tensor<1, 3>
      slide(const Values &values) const;

      /** Displacement in the configuration @p values [mm]. */
      Tensor<1, 3>
      displacement(const Values &values) const;

      /** Part of what slides that adds to the displacement: that of the step
       * in which there is contact. */
      double
      share_of_slide() const
      {
        return share;
      }

      /** Whether the particles lie on surfaces and turn with the sections. */
      bool
      has_sections() const
      {
        return n_blocks == max_blocks;
      }

      /** How the n_blocks first blocks make up the separation [-, mm]. */
      const Weights &
      separation_weights() const
      {
        return weights;
      }

      /** How those of the axes of both fibers make up their tangents. */
      const std::array<double, n_axis_blocks> &
      tangent_weights() const
      {
        return slopes;
      }

      /**
       * What both @p components of friction, along the fibers and across, make
       * of the separation and, without sections, of the tangent of one side:
       * the force on a block is that, times its weight.
       */
      Tensor<1, 3>
      force_by_separation(const std::array<double, 2> &components) const
      {
        return components[0] * by_separation[0] +
               components[1] * by_separation[1];
      }

      Tensor<1, 3>
      force_by_tangent(const unsigned int           side,
                       const std::array<double, 2> &components) const
      {
        return components[0] * by_tangent[side][0] +
               components[1] * by_tangent[side][1];
      }

      unsigned int fiber_a, fiber_b;
      int          orientation;
      unsigned int n_blocks;
      double       s_a, s_b; /**< [mm] */
      double       weight;   /**< [mm] */
      Tensor<1, 3> normal;

      /** Directions of the plane of contact, along the fibers and across. */
      Tensor<1, 3> axes[2];

      /** Local numbers, in halves for both fibers: the axis comes first. */
      Blocks blocks;

    private:
      /** Add the blocks of one fiber: @p side is 0 for a, and 1 for b. */
      void
      add_particle(const System::State &state, const unsigned int side);

      /**
       * 1 where sides touch, 0 where an end is pushed straight on: no frame
       * turns with the pair there, and it has no friction.
       */
      double
      side_on(const Pair &pair) const;

      /** Between the particles in the configuration @p values. */
      Tensor<1, 3>
      separation(const Values &values) const;

      /** Set how particles slide with the blocks. */
      void
      set_derivatives(const Motion &motion);

      /** Both components of what the motion or place @p pair makes. */
      std::array<double, 2>
      components(const Pair &pair) const;

      /** How the blocks make up the separation of the particles [-, mm]. */
      Weights weights;

      /** How those of the axes make up the tangents of both fibers [1/mm]. */
      std::array<double, n_axis_blocks> slopes;

      /**
       * How components of what slides grow with the separation of the
       * particles and, without sections, with the tangents of both fibers
       * [-, mm].
       */
      Tensor<1, 3> by_separation[2];
      Tensor<1, 3> by_tangent[2][2];

      /** Displacement where all blocks are zero [mm]. */
      Tensor<1, 3> offset;
      double       share = 1.;
    };
  } // namespace Contributions
} // namespace Heddle

#endif
