#ifndef heddle_beam_hermite_element_h
#define heddle_beam_hermite_element_h

#include <heddle/beam/element.h>

namespace Heddle
{
  namespace Beam
  {
    /**
     * The torsion-free element with six unknowns per node: position $r$ and
     * tangent $t = dr/ds$, between which the centerline is the cubic Hermite
     * curve. As $t$ is the derivative in the reference arc length, and the
     * element scales it by its own length, the centerline is C1 on uneven
     * meshes too.
     *
     * <b>Axial.</b> $\epsilon = (r' \cdot r' - 1) / 2$ at the two nodes and the
     * middle, with the weights 1/6, 4/6, 1/6 (strains 0, 1, 2). Sampled at
     * Gauss points it would lock the membrane.
     *
     * <b>Bending.</b> The curvature is taken as $|r''|$, which is exact but for
     * terms of the order of $\epsilon$. The reference has a curvature of the
     * magnitude $\kappa_0$. Nothing resists the spin of the section about the
     * axis, so the bending energy is the minimum over the spin,
     * @f[ W = \min_\varphi \tfrac12 EI\, |r'' - \kappa_0 n(\varphi)|^2
     *       = \tfrac12 EI\, (|r''| - \kappa_0)^2, @f]
     * at the two Gauss points (strains 3, 4). The kink at $r'' = 0$ is rounded:
     * @f[ W = \tfrac12 EI\, (m(r'') - m_0)^2, \quad
     *     m(x) = \sqrt{x \cdot x + c^2 \kappa_0^2}, \quad
     *     m_0  = \kappa_0 \sqrt{1 + c^2}, \quad c = 0.01, @f]
     * which has no force at $|r''| = \kappa_0$, and is $\tfrac12 EI\, |r''|^2$
     * with a constant matrix for a straight reference. A reference that turns
     * by less than 1e-8 over the element is taken as straight: its direction is
     * round-off.
     *
     * A curved reference so has no stiffness against turning the plane of its
     * curvature. That is the model, not a defect of the discretisation.
     *
     * <b>Predicted stresses.</b> $r''$ is linear in the unknowns: the bending
     * part of the tangent is always the exact one, and only the axial stresses
     * that were predicted are used.
     */
    class HermiteElement : public Element
    {
    public:
      ElementKind
      kind() const override;

      unsigned int
      n_nodes() const override;

      unsigned int
      n_blocks_per_node() const override;

      unsigned int
      n_strains() const override;

      void
      strains(const Tensor<1, 3> *blocks,
              const double        length,
              double             *strains) const override;

      void
      predict_stresses(const Section      &section,
                       const Tensor<1, 3> *blocks,
                       const Tensor<1, 3> *increment,
                       const double        length,
                       const double       *reference_strains,
                       double             *stresses) const override;

      double
      assemble(const Section      &section,
               const Tensor<1, 3> *blocks,
               const double        length,
               const double       *reference_strains,
               const double       *predicted_stresses,
               double             *residual,
               double             *tangent) const override;

      SectionState
      section_state(const Section      &section,
                    const Tensor<1, 3> *blocks,
                    const double        length,
                    const double       *reference_strains) const override;

      EnergySplit
      energy_split(const Section      &section,
                   const Tensor<1, 3> *blocks,
                   const double        length,
                   const double       *reference_strains) const override;

      double
      alignment(const Tensor<1, 3> *blocks, const double length) const override;
    };
  } // namespace Beam
} // namespace Heddle

#endif
