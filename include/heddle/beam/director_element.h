#ifndef heddle_beam_director_element_h
#define heddle_beam_director_element_h

#include <heddle/beam/element.h>

#include <array>

namespace Heddle
{
  namespace Beam
  {
    /** Shape functions of a Lagrange element at one Gauss point. */
    template <int degree>
    struct LagrangePoint
    {
      /** The weights of all points sum to one. */
      double weight;

      std::array<double, degree + 1> value;

      /** Derivatives in the coordinate that runs from 0 to 1. */
      std::array<double, degree + 1> slope;
    };



    /**
     * The element with nine unknowns per node: a material point of the fiber is
     * @f[ x(s, \xi) = r(s) + \xi_1 g_1(s) + \xi_2 g_2(s), @f]
     * with position $r$ and section vectors $g_1, g_2$ interpolated by Lagrange
     * polynomials of degree @p degree on equally spaced nodes. Sections stay
     * plane and may stretch and shear; nothing is parametrised by rotations.
     *
     * Twelve strains per integration point, each quadratic in the unknowns, a
     * prime being the derivative in the reference arc length:
     *
     * | index | strain | formula |
     * |---|---|---|
     * | 0 | axial | $\epsilon = (r' \cdot r' - 1) / 2$ |
     * | 1, 2 | transverse shear | $\gamma_a = r' \cdot g_a$ |
     * | 3, 4 | section stretch | $E_a = (g_a \cdot g_a - 1) / 2$ |
     * | 5 | section shear | $g_1 \cdot g_2$ |
     * | 6, 7 | bending | $\kappa_a = r' \cdot g_a'$ |
     * | 8 | twist, right-handed | $(g_2 \cdot g_1' - g_1 \cdot g_2')/2$ |
     * | 9, 10 | gradient of the stretch | $g_a \cdot g_a'$ |
     * | 11 | gradient of the shear | $(g_1 \cdot g_2' + g_2 \cdot g_1')/2$ |
     *
     * The strains of the reference are subtracted, so references may be curved,
     * twisted or pre-strained.
     *
     * <b>Energy per length.</b> Axial strain and section stretch are coupled:
     * @f[ W_{as} = \tfrac12 EA\, \epsilon^2 + \tfrac12 \lambda A (h_1 + h_2)^2
     *              + S A (h_1^2 + h_2^2), \quad h_a = E_a + \nu \epsilon,
     *     \quad \lambda = \frac{2 S \nu}{1 - 2 \nu}. @f]
     * A section that is free to stretch takes $h_a = 0$, that is
     * $E_a = -\nu \epsilon$, and what is left is exactly $EA$, whatever $E$,
     * $S$ and $\nu$. With $S = E / (2 (1 + \nu))$ this *is* the isotropic
     * three-dimensional law $\frac A2 [\lambda (\epsilon + E_1 + E_2)^2 + 2 S
     * (\epsilon^2 + E_1^2 + E_2^2)]$ with its square completed. All other
     * strains are uncoupled: shear $k_s G A$, section shear $S A$, torsion
     * $G J$, gradients $S I, S I, 2 S I$, and bending $E I$. The last is not
     * the three-dimensional law over the section, which, the section being
     * unable to answer to bending by warping, would be too stiff by
     * $(1 - \nu) / ((1 + \nu)(1 - 2 \nu))$.
     *
     * The gradient terms keep linear elements free of a thickness mode
     * $(+d, -d)$ without energy. Gauss integration with @p degree points, one
     * less than exact, keeps shear and membrane from locking.
     */
    template <int degree>
    class DirectorElement : public Element
    {
    public:
      DirectorElement();

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

    private:
      std::array<LagrangePoint<degree>, degree> points;
    };
  } // namespace Beam
} // namespace Heddle

#endif
