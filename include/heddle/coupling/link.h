#ifndef heddle_coupling_link_h
#define heddle_coupling_link_h

#include <deal.II/base/tensor.h>

#include <array>

namespace Heddle
{
  /** Kernel: a particle of a fiber and the one of the matrix at its place. */
  namespace Coupling
  {
    using namespace dealii;

    /** Most weights of a link: four of a fiber, 27 of a hexahedron. */
    constexpr unsigned int max_weights = 31;

    /**
     * An elastic link between two particles that were at the same place when
     * the fiber was embedded (Durville, 2007): the energy is
     * @f$ \frac12 k |d - d_0|^2 @f$ with the distance @f$ d = \sum_a w_a x_a
     * @f$. The weights of the fiber's blocks are its shape functions, those of
     * the nodes of the matrix are minus the shape functions of the hexahedron;
     * @f$ d_0 @f$ is the distance at embedding, zero but for round-off.
     */
    struct Link
    {
      unsigned int                    n          = 0; /**< number of weights */
      unsigned int                    n_of_fiber = 0; /**< the first of them */
      std::array<double, max_weights> weights;        /**< [-] */
      double                          stiffness = 0.; /**< k [N/mm] */
      Tensor<1, 3>                    offset;         /**< d_0 [mm] */

      /** Distance d - d_0 of the particles for these places of blocks [mm]. */
      Tensor<1, 3>
      stretch(const Tensor<1, 3> *places) const;

      /** Force of the link on the particle of the fiber [N]. */
      Tensor<1, 3>
      force(const Tensor<1, 3> *places) const
      {
        return -stiffness * stretch(places);
      }

      /**
       * Return the energy [N mm] and write its gradient (3n numbers) and, if
       * @p tangent is not null, its Hessian (3n x 3n by rows), which is
       * constant.
       */
      double
      assemble(const Tensor<1, 3> *places,
               double             *residual,
               double             *tangent) const;
    };
  } // namespace Coupling
} // namespace Heddle

#endif
