#ifndef heddle_solid_neo_hookean_h
#define heddle_solid_neo_hookean_h

#include <heddle/solid/material.h>

namespace Heddle
{
  namespace Solid
  {
    /**
     * The compressible neo-Hookean law, its parts decoupled: $W_s = \frac12 \mu
     * (J^{-2/3}\, \mathrm{tr}\, F^T F - 3)$ and $U = \frac14 K (\theta^2 - 1 -
     * 2 \ln \theta)$ with $\theta = J = \det F$ (Simo and Taylor, 1982). For
     * large strains; the energy is infinite where J goes to zero.
     */
    class NeoHookean : public Material
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
