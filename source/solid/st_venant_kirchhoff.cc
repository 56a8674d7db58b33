#include <heddle/solid/st_venant_kirchhoff.h>

namespace Heddle
{
  namespace Solid
  {
    MaterialLaw
    StVenantKirchhoff::law() const
    {
      return MaterialLaw::st_venant_kirchhoff;
    }



    bool
    StVenantKirchhoff::is_linear() const
    {
      return false;
    }



    double
    StVenantKirchhoff::shape(const Tensor<2, 3> &F,
                             Tensor<2, 3>       *stress,
                             Tangent            *tangent) const
    {
      const SymmetricTensor<2, 3> deviatoric = deviator(strain(F));
      if (stress != nullptr)
        *stress = 2. * shear_modulus * (F * Tensor<2, 3>(deviatoric));
      if (tangent != nullptr)
        {
          const Tensor<2, 3> left_cauchy_green = F * transpose(F);
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int J = 0; J < 3; ++J)
              for (unsigned int k = 0; k < 3; ++k)
                for (unsigned int L = 0; L < 3; ++L)
                  (*tangent)[9 * (3 * i + J) + 3 * k + L] =
                    shear_modulus *
                    ((i == k ? 2. * deviatoric[J][L] : 0.) +
                     (J == L ? left_cauchy_green[i][k] : 0.) +
                     F[i][L] * F[k][J] - 2. / 3. * F[i][J] * F[k][L]);
        }
      return shear_modulus * (deviatoric * deviatoric);
    }



    double
    StVenantKirchhoff::dilatation(const Tensor<2, 3> &F,
                                  Tensor<2, 3>       &gradient) const
    {
      gradient = F;
      return .5 * (F.norm_square() - 3.);
    }



    void
    StVenantKirchhoff::add_dilatation_tangent(const Tensor<2, 3> &,
                                              const double factor,
                                              Tangent     &tangent) const
    {
      for (unsigned int i = 0; i < 9; ++i)
        tangent[10 * i] += factor;
    }



    Material::Volume
    StVenantKirchhoff::volume(const double dilatation) const
    {
      return {.5 * bulk_modulus * dilatation * dilatation,
              bulk_modulus * dilatation,
              bulk_modulus};
    }
  } // namespace Solid
} // namespace Heddle
