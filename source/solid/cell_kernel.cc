#include <heddle/solid/cell_kernel.h>

#include <algorithm>
#include <limits>

namespace Heddle
{
  namespace Solid
  {
    CellKernel::CellKernel(const Material    &material,
                           const unsigned int n_nodes,
                           const unsigned int n_points,
                           const bool         mean_dilatation)
      : material(material)
      , n_nodes(n_nodes)
      , n_points(n_points)
      , mean_dilatation(mean_dilatation)
      , deformation(n_points)
      , dilatation_gradient(n_points)
      , dilatation(n_points)
      , blocks(9 * n_nodes * n_nodes)
      , mean_gradient(3 * n_nodes)
    {
      Assert(n_nodes == 8 || n_nodes == 27, ExcInternalError());
    }



    bool
    CellKernel::find_deformation(const double       *gradients,
                                 const double       *weights,
                                 const Tensor<1, 3> *positions)
    {
      cell_volume = 0.;
      double mean = 0.;
      for (unsigned int q = 0; q < n_points; ++q)
        {
          Tensor<2, 3>  F;
          const double *gradient = gradients + 3 * n_nodes * q;
          for (unsigned int a = 0; a < n_nodes; ++a, gradient += 3)
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int J = 0; J < 3; ++J)
                F[i][J] += positions[a][i] * gradient[J];
          if (!material.is_admissible(F))
            return false;
          deformation[q]      = F;
          dilatation[q].value = material.dilatation(F, dilatation_gradient[q]);
          mean += weights[q] * dilatation[q].value;
          cell_volume += weights[q];
        }

      mean /= cell_volume;
      for (Dilatation &point : dilatation)
        {
          if (mean_dilatation)
            point.value = mean;
          point.volume = material.volume(point.value);
        }
      return true;
    }



    template <unsigned int n>
    void
    CellKernel::add_residual(const double *gradients,
                             const double *weights,
                             double       *residual) const
    {
      for (unsigned int q = 0; q < n_points; ++q)
        {
          Tensor<2, 3> stress;
          material.shape(deformation[q], &stress, /*tangent=*/nullptr);
          stress += dilatation[q].volume.pressure * dilatation_gradient[q];
          stress *= weights[q];
          const double *gradient = gradients + 3 * n * q;
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int i = 0; i < 3; ++i)
              residual[3 * a + i] += stress[i][0] * gradient[3 * a] +
                                     stress[i][1] * gradient[3 * a + 1] +
                                     stress[i][2] * gradient[3 * a + 2];
        }
    }



    template <unsigned int n>
    void
    CellKernel::add_tangent(const double *gradients,
                            const double *weights,
                            double       *tangent)
    {
      std::fill(blocks.begin(), blocks.end(), 0.);
      Material::Tangent moduli;
      for (unsigned int q = 0; q < n_points; ++q)
        {
          const Material::Volume &volume = dilatation[q].volume;
          material.shape(deformation[q], /*stress=*/nullptr, &moduli);
          material.add_dilatation_tangent(
            deformation[q], volume.pressure, moduli);
          if (!mean_dilatation)
            for (unsigned int r = 0; r < 9; ++r)
              for (unsigned int c = 0; c < 9; ++c)
                moduli[9 * r + c] += volume.modulus *
                                     dilatation_gradient[q][r / 3][r % 3] *
                                     dilatation_gradient[q][c / 3][c % 3];

          const double *gradient = gradients + 3 * n * q;
          double        component[3][n];
          for (unsigned int b = 0; b < n; ++b)
            for (unsigned int L = 0; L < 3; ++L)
              component[L][b] = gradient[3 * b + L];

          double *block = blocks.data();
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int i = 0; i < 3; ++i)
              {
                double row[9];
                for (unsigned int c = 0; c < 9; ++c)
                  row[c] = weights[q] *
                           (gradient[3 * a] * moduli[27 * i + c] +
                            gradient[3 * a + 1] * moduli[27 * i + 9 + c] +
                            gradient[3 * a + 2] * moduli[27 * i + 18 + c]);
                for (unsigned int k = 0; k < 3; ++k, block += n)
                  for (unsigned int b = 0; b < n; ++b)
                    block[b] += row[3 * k] * component[0][b] +
                                row[3 * k + 1] * component[1][b] +
                                row[3 * k + 2] * component[2][b];
              }
        }

      const double *block = blocks.data();
      for (unsigned int r = 0; r < 3 * n; ++r)
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int b = 0; b < n; ++b)
            tangent[3 * n * r + 3 * b + k] = *block++;
    }



    template <unsigned int n>
    void
    CellKernel::add_mean_term(const double *gradients,
                              const double *weights,
                              double       *tangent)
    {
      std::fill(mean_gradient.begin(), mean_gradient.end(), 0.);
      for (unsigned int q = 0; q < n_points; ++q)
        {
          const Tensor<2, 3> weighted = weights[q] * dilatation_gradient[q];
          const double      *gradient = gradients + 3 * n * q;
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int i = 0; i < 3; ++i)
              mean_gradient[3 * a + i] += weighted[i][0] * gradient[3 * a] +
                                          weighted[i][1] * gradient[3 * a + 1] +
                                          weighted[i][2] * gradient[3 * a + 2];
        }
      const double factor = dilatation[0].volume.modulus / cell_volume;
      for (unsigned int r = 0; r < 3 * n; ++r)
        for (unsigned int c = 0; c < 3 * n; ++c)
          tangent[3 * n * r + c] +=
            factor * mean_gradient[r] * mean_gradient[c];
    }



    double
    CellKernel::assemble(const double       *gradients,
                         const double       *weights,
                         const Tensor<1, 3> *positions,
                         double             *residual,
                         double             *tangent)
    {
      if (!find_deformation(gradients, weights, positions))
        return std::numeric_limits<double>::infinity();

      if (residual != nullptr)
        {
          std::fill_n(residual, 3 * n_nodes, 0.);
          if (n_nodes == 8)
            add_residual<8>(gradients, weights, residual);
          else
            add_residual<27>(gradients, weights, residual);
        }
      if (tangent != nullptr)
        {
          if (n_nodes == 8)
            add_tangent<8>(gradients, weights, tangent);
          else
            add_tangent<27>(gradients, weights, tangent);
          if (mean_dilatation && n_nodes == 8)
            add_mean_term<8>(gradients, weights, tangent);
          else if (mean_dilatation)
            add_mean_term<27>(gradients, weights, tangent);
        }

      double energy = 0.;
      for (unsigned int q = 0; q < n_points; ++q)
        energy +=
          weights[q] * (material.shape(deformation[q], nullptr, nullptr) +
                        dilatation[q].volume.energy);
      return energy;
    }



    void
    CellKernel::evaluate(const double       *gradients,
                         const double       *weights,
                         const Tensor<1, 3> *positions,
                         PointState         *states)
    {
      const bool admissible = find_deformation(gradients, weights, positions);
      (void)admissible;
      Assert(admissible, ExcInternalError());
      for (unsigned int q = 0; q < n_points; ++q)
        {
          states[q].strain = material.strain(deformation[q]);
          states[q].stress =
            material.cauchy_stress(deformation[q], dilatation[q].value);
          states[q].von_mises = von_mises(states[q].stress);
          states[q].volume    = weights[q];
        }
    }
  } // namespace Solid
} // namespace Heddle
