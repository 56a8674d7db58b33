#include <heddle/contact/pair_turning.h>
#include <heddle/contributions/friction_element.h>

#include <algorithm>
#include <cmath>

namespace Heddle
{
  namespace Contributions
  {
    namespace
    {
      /** Where the frame of a pair is so well defined, sides touch. */
      constexpr double well_defined = 0.3;

      /** Less of a side than this is round-off. */
      constexpr double least_side_on = 1e-8;



      /** Coordinates in the section of the vector @p r from the axis. */
      std::array<double, 2>
      place_in_section(const System::State        &state,
                       const unsigned int          fiber,
                       const System::SectionPoint &point,
                       const Tensor<1, 3>         &r)
      {
        Tensor<1, 3> g[2];
        for (unsigned int direction = 0; direction < 2; ++direction)
          for (unsigned int i = 0; i < 2; ++i)
            g[direction] +=
              point.values[i] * state.block(fiber, point.blocks[i] + direction);

        // The nearest vector of the section, by the normal equations.
        const double a = g[0] * g[0], b = g[0] * g[1], c = g[1] * g[1];
        const double p = r * g[0], q = r * g[1], determinant = a * c - b * b;
        return {{(c * p - b * q) / determinant, (a * q - b * p) / determinant}};
      }
    } // namespace



    FrictionElement::FrictionElement(const System::State           &state,
                                     const Contact::ContactElement &touching)
      : fiber_a(touching.fiber_a)
      , fiber_b(touching.fiber_b)
      , orientation(touching.orientation)
      , n_blocks(0)
      , s_a(touching.s_a)
      , s_b(touching.s_b)
      , weight(touching.weight)
      , normal(touching.normal)
    {
      add_particle(state, 0);
      add_particle(state, 1);
    }



    void
    FrictionElement::add_particle(const System::State &state,
                                  const unsigned int   side)
    {
      const System::FiberSpace   &space = state.space;
      const unsigned int          fiber = side == 0 ? fiber_a : fiber_b;
      const double                s     = side == 0 ? s_a : s_b;
      const double                sign  = side == 0 ? 1. : -1.;
      const int                   first = state.local_block(fiber);
      std::array<double, 4>       slope;
      const System::MaterialPoint axis = space.locate(fiber, s, slope);
      for (unsigned int i = 0; i < 4; ++i, ++n_blocks)
        {
          blocks[n_blocks]     = first + axis.blocks[i];
          weights[n_blocks]    = sign * axis.values[i];
          slopes[4 * side + i] = slope[i];
        }
      if (space.n_blocks_per_node() == 2)
        return;

      const System::SectionPoint section = space.locate_section(fiber, s);
      const auto                 place   = place_in_section(
        state, fiber, section, (-sign * space.fiber(fiber).radius) * normal);
      for (unsigned int direction = 0; direction < 2; ++direction)
        for (unsigned int i = 0; i < 2; ++i, ++n_blocks)
          {
            blocks[n_blocks]  = first + section.blocks[i] + direction;
            weights[n_blocks] = sign * place[direction] * section.values[i];
          }
    }



    Tensor<1, 3>
    FrictionElement::separation(const Values &values) const
    {
      Tensor<1, 3> sum;
      for (unsigned int i = 0; i < n_blocks; ++i)
        sum += weights[i] * values[blocks[i]];
      return sum;
    }



    FrictionElement::Pair
    FrictionElement::pair(const Values &values) const
    {
      Pair result;
      for (unsigned int side = 0; side < 2; ++side)
        {
          const unsigned int first = side * (n_blocks / 2);
          Tensor<1, 3>       position, surface;
          for (unsigned int i = 0; i < 4; ++i)
            {
              const Tensor<1, 3> &block = values[blocks[first + i]];
              position += weights[first + i] * block;
              result.tangent[side] += slopes[4 * side + i] * block;
            }
          for (unsigned int i = first + 4; i < first + n_blocks / 2; ++i)
            surface += weights[i] * values[blocks[i]];
          result.connection += position;
          result.separation += position + surface;
        }
      return result;
    }



    Tensor<2, 3>
    FrictionElement::Pair::frame(const int orientation) const
    {
      return Contact::pair_frame(
        tangent[0], tangent[1], orientation, connection);
    }



    double
    FrictionElement::side_on(const Pair &pair) const
    {
      // 1 if the connection is normal to both tangents.
      const Tensor<1, 3> a = pair.tangent[0] / pair.tangent[0].norm(),
                         b = pair.tangent[1] / pair.tangent[1].norm(),
                         c = pair.connection / pair.connection.norm();
      const double triple = cross_product_3d(a, b) * c, cosine = a * b;
      Tensor<1, 3> middle = a + orientation * b;
      middle /= middle.norm();
      const double defined =
        triple * triple + cosine * cosine * (1. - std::pow(middle * c, 2));
      const double part = std::min(1., defined / well_defined);
      return part < least_side_on ? 0. : part;
    }



    FrictionElement::Motion
    FrictionElement::motion(const System::State &state) const
    {
      Motion result;
      result.now    = pair(state.current());
      const auto &t = result.now.tangent;
      result.cosine =
        t[0] * t[1] / std::sqrt(t[0].norm_square() * t[1].norm_square());
      result.side_on     = side_on(result.now);
      result.frame       = result.now.frame(orientation);
      const Pair   then  = pair(state.accepted());
      Tensor<2, 3> frame = then.frame(orientation);
      result.gap_before =
        frame[2] * then.connection -
        (state.space.fiber(fiber_a).radius + state.space.fiber(fiber_b).radius);

      const Tensor<1, 3> began =
        transpose(result.frame) * (frame * then.separation);
      result.displacement = result.now.separation - began;
      result.displacement -= (result.displacement * normal) * normal;
      return result;
    }



    void
    FrictionElement::set_displacement(const Motion       &motion,
                                      const double        part,
                                      const Tensor<1, 3> &left,
                                      const int           left_orientation)
    {
      const Tensor<2, 3> &frame = motion.frame;
      axes[0]                   = frame[0] - (frame[0] * normal) * normal;
      axes[0] /= axes[0].norm();
      axes[1] = cross_product_3d(normal, axes[0]);

      // Near a right angle the frame that is remembered may be another one.
      const Tensor<1, 3> turned =
        left_orientation == orientation
          ? transpose(frame) * left
          : transpose(motion.now.frame(left_orientation)) * left;
      share  = part;
      offset = turned + share * motion.displacement;
      offset -= (offset * normal) * normal;

      set_derivatives(motion);
      const auto linear = components(motion.now);
      for (unsigned int k = 0; k < 2; ++k)
        offset -= share * linear[k] * axes[k];
    }



    void
    FrictionElement::set_derivatives(const Motion &motion)
    {
      for (unsigned int k = 0; k < 2; ++k)
        by_separation[k] = axes[k];
      if (has_sections())
        return;

      // The rotation w of the pair takes the arm d between the particles along:
      // a motion less w x d rubs. The moment of both forces is borne by what
      // turns the pair, so all moments balance. On surfaces there is no arm.
      const auto          turning = Contact::pair_turning(motion.now.tangent[0],
                                                 motion.now.tangent[1],
                                                 orientation,
                                                 motion.now.connection);
      const Tensor<1, 3> &arm     = motion.now.separation;
      const double        along = arm * axes[0], across = arm * axes[1],
                   up    = arm * normal;
      const auto left_by = [&](const Tensor<1, 3> *w, const unsigned int k) {
        return k == 0 ? across * w[2] - up * w[1] : up * w[0] - along * w[2];
      };
      for (unsigned int k = 0; k < 2; ++k)
        {
          by_separation[k] += left_by(turning.by_connection, k);
          for (unsigned int side = 0; side < 2; ++side)
            by_tangent[side][k] = left_by(turning.by_tangent[side], k);
        }
    }



    FrictionElement::Derivative::Derivative(const FrictionElement &element)
    {
      for (unsigned int k = 0; k < 2; ++k)
        for (unsigned int i = 0; i < element.n_blocks; ++i)
          {
            Tensor<1, 3> row = element.weights[i] * element.by_separation[k];
            if (!element.has_sections())
              row += element.slopes[i] * element.by_tangent[i / 4][k];
            for (unsigned int d = 0; d < 3; ++d)
              rows[k][3 * i + d] = row[d];
          }
    }



    std::array<double, 2>
    FrictionElement::components(const Pair &pair) const
    {
      // The same as by the derivative, in a third of the operations.
      std::array<double, 2> sums;
      for (unsigned int k = 0; k < 2; ++k)
        {
          sums[k] = by_separation[k] * pair.separation;
          for (unsigned int side = 0; side < 2 && !has_sections(); ++side)
            sums[k] += by_tangent[side][k] * pair.tangent[side];
        }
      return sums;
    }



    Tensor<1, 3>
    FrictionElement::slide(const Values &values) const
    {
      // Where there are sections the tangents do not count.
      Pair motion;
      if (has_sections())
        motion.separation = separation(values);
      else
        motion = pair(values);
      const auto moved = components(motion);
      return moved[0] * axes[0] + moved[1] * axes[1];
    }



    Tensor<1, 3>
    FrictionElement::displacement(const Values &values) const
    {
      return offset + share * slide(values);
    }
  } // namespace Contributions
} // namespace Heddle
