#ifndef heddle_contributions_fabric_bending_h
#define heddle_contributions_fabric_bending_h

#include <heddle/base/expression.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <string>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /**
     * How the sides of a woven sample move when it is bent to a cylinder: a
     * point at (X, Z), X along the yarns that are bent and Z above the neutral
     * surface, goes to
     * @f[
     *   x = \left(\frac{1}{\kappa} - Z\right) \sin \kappa X, \qquad
     *   z = \frac{1}{\kappa} - \left(\frac{1}{\kappa} - Z\right)
     *       \cos \kappa X
     * @f]
     * with the curvature @f$\kappa@f$ times the ramp of the load factor;
     * lengths in the neutral surface and across stay as they are. Positions
     * here are counted from a point of that surface.
     */
    class FabricBending
    {
    public:
      /** Bent are yarns along x or y, @p direction 0 or 1; at ramp 1 to
       * @p curvature [1/mm], upwards at the ends where it is positive. */
      FabricBending(const unsigned int direction,
                    const double       curvature,
                    const std::string &ramp);

      unsigned int
      direction() const
      {
        return along;
      }

      /** Formulas of x, y, z, t [mm]. */
      std::array<std::string, 3>
      displacement() const;

      /** Formula of x, y, t: angle by which all turns about axis() [rad]. */
      std::string
      turn_angle() const;

      /** Positive turns lift what is ahead along the yarns. */
      Tensor<1, 3>
      axis() const;

      /** [1/mm] */
      double
      curvature(const double load_factor) const;

      Tensor<1, 3>
      displacement(const Tensor<1, 3> &position,
                   const double        load_factor) const;

      /**
       * Where a point at @p place of the bent fabric was in the flat one: the
       * inverse of the motion, for turns of less than half a circle. With
       * @f$h = |(\kappa x, 1 - \kappa z)|@f$
       * @f[
       *   X = \frac{1}{\kappa} \arctan \frac{\kappa x}{1 - \kappa z}, \qquad
       *   Z = \frac{2 z - \kappa (x^2 + z^2)}{1 + h}.
       * @f]
       */
      Tensor<1, 3>
      flattened(const Tensor<1, 3> &place, const double load_factor) const;

      /** Its derivative by the curvature [mm^2]. */
      Tensor<1, 3>
      displacement_rate(const Tensor<1, 3> &position,
                        const double        load_factor) const;

      /** Derivative of the angle by the curvature: a vector along the axis
       * [mm].
       */
      Tensor<1, 3>
      turn_rate(const Tensor<1, 3> &position) const
      {
        return position[along] * axis();
      }

      /** Along the bent yarns, a unit vector. */
      Tensor<1, 3>
      tangent(const Tensor<1, 3> &position, const double load_factor) const;

    private:
      unsigned int along;
      std::string  curvature_text;
      Expression   curvature_formula;
    };
  } // namespace Contributions
} // namespace Heddle

#endif
