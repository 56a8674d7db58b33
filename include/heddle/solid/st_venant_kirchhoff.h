#ifndef heddle_solid_st_venant_kirchhoff_h
#define heddle_solid_st_venant_kirchhoff_h

#include <heddle/solid/material.h>

namespace Heddle
{
  namespace Solid
  {
    /**
     * The law of Saint-Venant and Kirchhoff, Hooke's with the strain of Green
     * and Lagrange $E = \frac12 (F^T F - I)$: $W_s = \mu\, \mathrm{dev} E :
     * \mathrm{dev} E$ and $U = \frac12 K \theta^2$ with $\theta = \mathrm{tr}
     * E$. For large rotations and moderate strains: in uniaxial compression to
     * less than $1/\sqrt{3}$ of the length it softens, and it does not resist
     * being turned inside out.
     */
    class StVenantKirchhoff : public Material
    {
    public:
      using Material::Material;

      MaterialLaw
      law() const override;

      bool
      is_linear() const override;

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
