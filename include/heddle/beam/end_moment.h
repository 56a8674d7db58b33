#ifndef heddle_beam_end_moment_h
#define heddle_beam_end_moment_h

#include <deal.II/base/tensor.h>

namespace Heddle
{
  namespace Beam
  {
    using namespace dealii;

    /**
     * Forces by which a moment acts on the vectors of a node that turn with the
     * section: the two section vectors of a director element, or the one
     * tangent of a Hermite element. The moment $M$ keeps its direction in
     * space.
     *
     * The spin of the section that belongs to increments $\delta g_a$ is the
     * one that fits them best, $\delta\theta$ with
     * @f[ A\, \delta\theta = \sum_a g_a \times \delta g_a, \quad
     *     A = \sum_a (g_a \cdot g_a) I - g_a \otimes g_a, @f]
     * so the virtual work $M \cdot \delta\theta$ is that of the forces
     * @f[ f_a = m \times g_a, \quad A m = M. @f]
     * They have no resultant, their moment $\sum_a g_a \times f_a$ is $M$
     * exactly, however stretched or sheared the section is, and they do no work
     * on the stretch and shear of a section at right angles. A single
     * tangent does not see the spin about itself: $f = M \times t / |t|^2$, and
     * the component of $M$ along the tangent does nothing.
     *
     * A moment of fixed direction has no potential for spatial rotations. The
     * derivative of the forces is then not symmetric, except when all turns are
     * about the direction of $M$.
     *
     * <b>Newton with mixed integration points.</b> A large step stretches the
     * vectors before it turns them, so $m$ is off by the square of the stretch.
     * It is therefore predicted as the stresses of an element are, by
     * predict_end_moment(), for the tangent only; the forces always use the
     * true one.
     *
     * @param[in]  moment    $M$ [N mm]
     * @param[in]  n_vectors 2 section vectors, or 1 tangent
     * @param[in]  vectors   the blocks of the node that follow its position
     * @param[in]  predicted $m$ from predict_end_moment(), or null
     * @param[out] forces    3 n_vectors numbers
     * @param[out] tangent   derivative of the forces in the vectors, row by
     * row, 3 n_vectors squared numbers, or null
     */
    void
    end_moment(const Tensor<1, 3> &moment,
               const unsigned int  n_vectors,
               const Tensor<1, 3> *vectors,
               const Tensor<1, 3> *predicted,
               double             *forces,
               double             *tangent);

    /**
     * Return $m$ of end_moment() after the step @p increment of the vectors,
     * $m = A^{-1} (M - (dA)\, m)$, where the $m$ on the right is @p predicted,
     * the one with which the step was computed, or the true one if that is
     * null.
     */
    Tensor<1, 3>
    predict_end_moment(const Tensor<1, 3> &moment,
                       const unsigned int  n_vectors,
                       const Tensor<1, 3> *vectors,
                       const Tensor<1, 3> *increment,
                       const Tensor<1, 3> *predicted);
  } // namespace Beam
} // namespace Heddle

#endif
