#include <heddle/solid/linear_material.h>

namespace Heddle
{
  namespace Solid
  {
    MaterialLaw
    LinearMaterial::law() const
    {
      return MaterialLaw::linear;
    }



    bool
    LinearMaterial::is_linear() const
    {
      return true;
    }



    bool
    LinearMaterial::is_admissible(const Tensor<2, 3> &) const
    {
      return true;
    }



    double
    LinearMaterial::shape(const Tensor<2, 3> &F,
                          Tensor<2, 3>       *stress,
                          Tangent            *tangent) const
    {
      const SymmetricTensor<2, 3> deviatoric = deviator(strain(F));
      if (stress != nullptr)
        *stress = Tensor<2, 3>(2. * shear_modulus * deviatoric);
      if (tangent != nullptr)
        {
          tangent->fill(0.);
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int J = 0; J < 3; ++J)
              {
                (*tangent)[9 * (3 * i + J) + 3 * i + J] += shear_modulus;
                (*tangent)[9 * (3 * i + J) + 3 * J + i] += shear_modulus;
                (*tangent)[9 * 4 * i + 4 * J] -= 2. / 3. * shear_modulus;
              }
        }
      return shear_modulus * (deviatoric * deviatoric);
    }



    double
    LinearMaterial::dilatation(const Tensor<2, 3> &F,
                               Tensor<2, 3>       &gradient) const
    {
      gradient = unit_symmetric_tensor<3>();
      return trace(F) - 3.;
    }



    void
    LinearMaterial::add_dilatation_tangent(const Tensor<2, 3> &,
                                           const double,
                                           Tangent &) const
    {
      // The trace of small strains is linear in F.
    }



    Material::Volume
    LinearMaterial::volume(const double dilatation) const
    {
      return {.5 * bulk_modulus * dilatation * dilatation,
              bulk_modulus * dilatation,
              bulk_modulus};
    }
  } // namespace Solid
} // namespace Heddle
