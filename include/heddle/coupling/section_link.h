#ifndef heddle_coupling_section_link_h
#define heddle_coupling_section_link_h

#include <deal.II/base/tensor.h>

#include <array>

namespace Heddle
{
  namespace Coupling
  {
    using namespace dealii;

    /**
     * A section of a fiber that turns about its axis in the matrix around it:
     * the energy is @f$ \frac12 k s^2 @f$ with
     * @f$ s = \frac12 (F G_2 \cdot g_1 - F G_1 \cdot g_2) @f$, the sine of the
     * angle by which the section vectors @f$ g_\alpha @f$ are ahead of those
     * that the deformation gradient F of the matrix makes of the vectors
     * @f$ G_\alpha @f$ at embedding. A common rotation keeps it, and a matrix
     * that is stretched without rotation does not turn the section.
     *
     * Blocks are, in this order, @f$ g_1, g_2 @f$ of the nodes of the fiber and
     * the nodes of the matrix: @f$ g_\alpha = \sum_i L_i g_{\alpha i} @f$,
     * @f$ F G_\alpha = \sum_a (\nabla N_a \cdot G_\alpha) x_a @f$.
     */
    struct SectionLink
    {
      unsigned int n          = 0; /**< number of blocks */
      unsigned int n_of_fiber = 0; /**< the first of them, two for each node */
      std::array<double, 2> weights; /**< L_i [-] */
      /** Of the nodes of the matrix: their parts of F G_alpha [1/mm]. */
      std::array<std::array<double, 2>, 27> slopes;
      double                                stiffness = 0.; /**< k [N mm] */

      /** s [-] */
      double
      turn(const Tensor<1, 3> *places) const;

      /**
       * Return the energy [N mm] and write its gradient (3n numbers) and, if
       * @p tangent is not null, its Hessian (3n x 3n by rows).
       */
      double
      assemble(const Tensor<1, 3> *places,
               double             *residual,
               double             *tangent) const;

    private:
      using Pair = std::array<Tensor<1, 3>, 2>;

      /** The two section vectors. */
      Pair
      vectors(const Tensor<1, 3> *places) const;

      /** What the matrix makes of them. */
      Pair
      carried(const Tensor<1, 3> *places) const;
    };
  } // namespace Coupling
} // namespace Heddle

#endif
