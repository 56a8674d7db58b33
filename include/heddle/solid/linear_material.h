#ifndef heddle_solid_linear_material_h
#define heddle_solid_linear_material_h

#include <heddle/solid/material.h>

namespace Heddle
{
  namespace Solid
  {
    /**
     * Hooke's law for small strains $\epsilon = \mathrm{sym} F - I$:
     * $W_s = \mu\, \mathrm{dev}\,\epsilon : \mathrm{dev}\,\epsilon$ and
     * $U = \frac12 K \theta^2$ with $\theta = \mathrm{tr}\,\epsilon$. The
     * tangent is constant. A rotation by the small angle $\alpha$ counts as a
     * strain of $\alpha^2 / 2$: it is for small rotations only.
     */
    class LinearMaterial : public Material
    {
    public:
      using Material::Material;

      MaterialLaw
      law() const override;

      bool
      is_linear() const override;

      bool
      is_admissible(const Tensor<2, 3> &F) const override;

      double
      shape(const Tensor<2, 3> &F,
            Tensor<2, 3>       *stress,
            Tangent            *tangent) const override;

      double
      dilatation(const Tensor<2, 3> &F, Tensor<2, 3> &gradient) const override;

      void
      add_dilatation_tangent(const Tensor<2, 3> &F,
                             const double        factor,
                             Tangent            &tangent) const override;

      Volume
      volume(const double dilatation) const override;
    };
  } // namespace Solid
} // namespace Heddle

#endif
