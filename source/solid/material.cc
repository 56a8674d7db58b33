#include <heddle/base/exceptions.h>
#include <heddle/base/number_text.h>
#include <heddle/solid/linear_material.h>
#include <heddle/solid/neo_hookean.h>
#include <heddle/solid/st_venant_kirchhoff.h>

#include <cmath>

namespace Heddle
{
  namespace Solid
  {
    bool
    Material::is_admissible(const Tensor<2, 3> &F) const
    {
      return determinant(F) > 0.;
    }



    SymmetricTensor<2, 3>
    Material::cauchy_stress(const Tensor<2, 3> &F,
                            const double        dilatation) const
    {
      Tensor<2, 3> stress, gradient;
      shape(F, &stress, /*tangent=*/nullptr);
      this->dilatation(F, gradient);
      stress += volume(dilatation).pressure * gradient;
      return is_linear() ? symmetrize(stress)
                         : symmetrize(stress * transpose(F)) / determinant(F);
    }



    SymmetricTensor<2, 3>
    Material::strain(const Tensor<2, 3> &F) const
    {
      const auto identity = unit_symmetric_tensor<3>();
      return is_linear() ? symmetrize(F) - identity
                         : .5 * (symmetrize(transpose(F) * F) - identity);
    }



    double
    von_mises(const SymmetricTensor<2, 3> &stress)
    {
      return std::sqrt(1.5) * deviator(stress).norm();
    }



    std::unique_ptr<Material>
    make_material(const MaterialLaw law,
                  const double      youngs_modulus,
                  const double      poisson_ratio)
    {
      require(youngs_modulus > 0.,
              "Matrix/Youngs modulus is " + number_text(youngs_modulus) +
                "; it must be above 0.");
      require(poisson_ratio > -1. && poisson_ratio < .5,
              "Matrix/Poisson ratio is " + number_text(poisson_ratio) +
                "; it must be above -1 and below 0.5.");
      const double shear_modulus = youngs_modulus / (2. * (1. + poisson_ratio));
      const double bulk_modulus =
        youngs_modulus / (3. * (1. - 2. * poisson_ratio));

      switch (law)
        {
          case MaterialLaw::linear:
            return std::make_unique<LinearMaterial>(shear_modulus,
                                                    bulk_modulus);
          case MaterialLaw::st_venant_kirchhoff:
            return std::make_unique<StVenantKirchhoff>(shear_modulus,
                                                       bulk_modulus);
          case MaterialLaw::neo_hookean:
            return std::make_unique<NeoHookean>(shear_modulus, bulk_modulus);
        }
      Assert(false, ExcInternalError());
      return nullptr;
    }
  } // namespace Solid
} // namespace Heddle
