#ifndef heddle_contributions_fabric_motion_h
#define heddle_contributions_fabric_motion_h

#include <heddle/base/expression.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <string>
#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /**
     * How the sides of a woven sample move: a point that was at (X, Y, Z) goes
     * to
     * @f[
     *   x = (1 + r \epsilon_1) X d_1(r \gamma) + (1 + r \epsilon_2) Y d_2(r
     *   \gamma) + Z e_z
     * @f]
     * with the ramp r of the load factor. The directions @f$d_1@f$ of the warp
     * and @f$d_2@f$ of the weft are x and y at first; a shear angle is that by
     * which the right angle between them has become smaller. Their formulas are
     * what the supports move by and what is measured along.
     */
    class FabricMotion
    {
    public:
      /** Of warp and weft. */
      template <typename Value>
      using Both = std::array<Value, 2>;

      enum class Shear
      {
        picture_frame, /**< both turn by half the angle and keep their length */
        simple         /**< the weft turns, and keeps its extent along y */
      };

      /** At ramp 1: @p strains [-], @p shear_angle [rad]. */
      FabricMotion(const Both<double> &strains,
                   const double        shear_angle,
                   const Shear         shear,
                   const std::string  &ramp);

      /** Formulas of x, y, t of the displacements along x and y [mm]. */
      Both<std::string>
      displacements() const;

      /** Formulas of t: angles by which sections turn about z [rad]. */
      Both<std::string>
      turn_angles() const;

      double
      shear_angle(const double load_factor) const;

      double
      strain(const unsigned int direction, const double load_factor) const;

      Both<Tensor<1, 3>>
      directions(const double load_factor) const;

      /** Their derivatives by the shear angle [1/rad]. */
      Both<Tensor<1, 3>>
      turning(const double load_factor) const;

      /** Derivatives of the turn angles by the shear angle [-]. */
      Both<double>
      turn_rates() const;

    private:
      Both<double> strains;
      double       angle;
      Shear        shear;
      std::string  ramp_text;
      Expression   ramp;

      /** Components along x and y of both directions: formulas of t, of which
       * the displacements are made, and the same to be evaluated. */
      Both<Both<std::string>>       formulas;
      Both<std::vector<Expression>> components;
    };
  } // namespace Contributions
} // namespace Heddle

#endif
