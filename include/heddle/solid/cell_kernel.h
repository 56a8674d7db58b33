#ifndef heddle_solid_cell_kernel_h
#define heddle_solid_cell_kernel_h

#include <heddle/solid/material.h>

#include <vector>

namespace Heddle
{
  namespace Solid
  {
    /** Strain and stress at a point of a cell, for output. */
    struct PointState
    {
      /** Of Green and Lagrange, or small for the linear law [-]. */
      SymmetricTensor<2, 3> strain;

      SymmetricTensor<2, 3> stress;         /**< Cauchy's [MPa] */
      double                von_mises = 0.; /**< [MPa] */
      double                volume    = 0.; /**< that the point stands for */
    };

    /**
     * Energy, residual and tangent of one hexahedral cell. The caller has a
     * mesh and its shape functions; here are only numbers of one cell:
     * - gradients of the shape functions in the reference configuration
     *   [1/mm], the component fastest, then the node, then the point,
     * - weights of the points: reference volumes [mm^3],
     * - positions of the nodes in the current configuration [mm].
     *
     * With mean dilatation (Nagtegaal, Parks and Rice, 1974; Simo, Taylor and
     * Pister, 1985) the energy of a cell of volume V is
     * $$ \int W_s(F)\, dV + V\, U(\bar\theta), \qquad
     *    \bar\theta = \frac{1}{V} \int \theta(F)\, dV, $$
     * so that a cell has one constraint of volume and not one per point.
     *
     * Arrays are made once: an object serves all cells of a mesh, one after the
     * other, and one thread.
     */
    class CellKernel
    {
    public:
      /** Cells have 8 or 27 nodes, in the order of the caller. */
      CellKernel(const Material    &material,
                 const unsigned int n_nodes,
                 const unsigned int n_points,
                 const bool         mean_dilatation);

      /**
       * Return the elastic energy [N mm] and, where the pointers are not null,
       * write its gradient into @p residual (3 numbers per node, in N) and the
       * tangent into @p tangent (row by row; symmetric).
       *
       * Where the material is not admissible at a point the energy is infinite,
       * and the arrays are left as they are: the caller shortens its step.
       */
      double
      assemble(const double       *gradients,
               const double       *weights,
               const Tensor<1, 3> *positions,
               double             *residual,
               double             *tangent);

      /**
       * Write strain and stress at the points to @p states; with mean
       * dilatation the pressure is that of the cell. The material must be
       * admissible at all points.
       */
      void
      evaluate(const double       *gradients,
               const double       *weights,
               const Tensor<1, 3> *positions,
               PointState         *states);

    private:
      /** What U sees, and what follows from it, at one point or in the cell. */
      struct Dilatation
      {
        double           value = 0.;
        Material::Volume volume;
      };

      /** Find F and the dilatations; return whether all are admissible. */
      bool
      find_deformation(const double       *gradients,
                       const double       *weights,
                       const Tensor<1, 3> *positions);

      template <unsigned int n>
      void
      add_residual(const double *gradients,
                   const double *weights,
                   double       *residual) const;

      template <unsigned int n>
      void
      add_tangent(const double *gradients,
                  const double *weights,
                  double       *tangent);

      template <unsigned int n>
      void
      add_mean_term(const double *gradients,
                    const double *weights,
                    double       *tangent);

      const Material    &material;
      const unsigned int n_nodes;
      const unsigned int n_points;
      const bool         mean_dilatation;

      double                    cell_volume = 0.;
      std::vector<Tensor<2, 3>> deformation;
      std::vector<Tensor<2, 3>> dilatation_gradient;
      std::vector<Dilatation>   dilatation;

      /** Tangent with the second node fastest, for vector instructions. */
      std::vector<double> blocks;

      /** Integral over the cell of the gradient of the dilatation. */
      std::vector<double> mean_gradient;
    };
  } // namespace Solid
} // namespace Heddle

#endif
