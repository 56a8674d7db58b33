#include <heddle/solid/neo_hookean.h>

#include <cmath>

namespace Heddle
{
  namespace Solid
  {
    namespace
    {
      /** Cofactors of @p F, the derivative of its determinant. */
      inline Tensor<2, 3>
      cofactors(const Tensor<2, 3> &F)
      {
        Tensor<2, 3> result;
        for (unsigned int i = 0; i < 3; ++i)
          result[i] = cross_product_3d(F[(i + 1) % 3], F[(i + 2) % 3]);
        return result;
      }
    } // namespace



    MaterialLaw
    NeoHookean::law() const
    {
      return MaterialLaw::neo_hookean;
    }



    bool
    NeoHookean::is_linear() const
    {
      return false;
    }



    double
    NeoHookean::shape(const Tensor<2, 3> &F,
                      Tensor<2, 3>       *stress,
                      Tangent            *tangent) const
    {
      const double       J       = determinant(F);
      const double       third   = F.norm_square() / 3.;
      const double       factor  = shear_modulus / std::cbrt(J * J);
      const Tensor<2, 3> inverse = cofactors(F) / J; // transposed
      if (stress != nullptr)
        *stress = factor * (F - third * inverse);
      if (tangent != nullptr)
        {
          // Derivative of the stress in F_kL; that of the transposed inverse
          // G_iJ is -G_iL G_kJ.
          const Tensor<2, 3> mixed = 2. / 3. * (third * inverse - F);
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              for (unsigned int k = 0; k < 3; ++k)
                for (unsigned int l = 0; l < 3; ++l)
                  (*tangent)[9 * (3 * i + j) + 3 * k + l] =
                    factor * ((i == k && j == l ? 1. : 0.) +
                              mixed[i][j] * inverse[k][l] -
                              2. / 3. * inverse[i][j] * F[k][l] +
                              third * inverse[i][l] * inverse[k][j]);
        }
      return 1.5 * (factor * third - shear_modulus);
    }



    double
    NeoHookean::dilatation(const Tensor<2, 3> &F, Tensor<2, 3> &gradient) const
    {
      gradient = cofactors(F);
      return F[0] * gradient[0];
    }



    void
    NeoHookean::add_dilatation_tangent(const Tensor<2, 3> &F,
                                       const double        factor,
                                       Tangent            &tangent) const
    {
      // The derivative of a cofactor in an element of another row and another
      // column is plus or minus the element in the third row and column.
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          {
            const unsigned int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
            const unsigned int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            double            *row = tangent.data() + 9 * (3 * i + j);
            row[3 * i1 + j1] += factor * F[i2][j2];
            row[3 * i2 + j2] += factor * F[i1][j1];
            row[3 * i1 + j2] -= factor * F[i2][j1];
            row[3 * i2 + j1] -= factor * F[i1][j2];
          }
    }



    Material::Volume
    NeoHookean::volume(const double dilatation) const
    {
      return {.25 * bulk_modulus *
                (dilatation * dilatation - 1. - 2. * std::log(dilatation)),
              .5 * bulk_modulus * (dilatation - 1. / dilatation),
              .5 * bulk_modulus * (1. + 1. / (dilatation * dilatation))};
    }
  } // namespace Solid
} // namespace Heddle
