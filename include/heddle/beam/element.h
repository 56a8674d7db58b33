#ifndef heddle_beam_element_h
#define heddle_beam_element_h

#include <deal.II/base/numbers.h>
#include <deal.II/base/tensor.h>

#include <cmath>
#include <memory>
#include <string>

namespace Heddle
{
  namespace Beam
  {
    using namespace dealii;

    /** Finite elements of fibers. */
    enum class ElementKind
    {
      hermite, /**< slender, without torsion, cubic */
      director /**< with torsion, shear and strains of the section */
    };

    /** How the user names them. */
    constexpr const char *
    word(const ElementKind kind)
    {
      switch (kind)
        {
          case ElementKind::hermite:
            return "hermite";
          case ElementKind::director:
            return "director";
        }
      return nullptr;
    }



    /**
     * Elastic constants of the section of a fiber. Those of a circle of radius
     * R are set by circular_section(); a verification or a lumped fiber may set
     * them one by one.
     */
    struct Section
    {
      double axial     = 0.; /**< E A [N] */
      double bending   = 0.; /**< E I [N mm^2] */
      double torsion   = 0.; /**< G J [N mm^2] */
      double shear     = 0.; /**< k_s G A [N] */
      double thickness = 0.; /**< S A, resists the strains of the section [N] */
      double gradient  = 0.; /**< S I, resists their gradients [N mm^2] */
      double poisson_ratio = 0.; /**< couples axial and section strains [-] */

      /**
       * Return the largest tensile stress along a fiber of radius @p radius R
       * [mm] in a section with such strains [MPa], below 0 where all of it is
       * compressed,
       * @f[ \sigma = E \left(\varepsilon + r |\kappa|\right), \qquad
       *     E = \frac{E A}{\pi R^2}, \qquad r = 2 \sqrt{\frac{E I}{E A}}. @f]
       * Of a full circle r is R, and of a fiber that stands for filaments their
       * radius: each is bent by itself.
       */
      double
      largest_stress(const double        radius,
                     const double        axial_strain,
                     const Tensor<1, 2> &curvature) const
      {
        const double outside = 2. * std::sqrt(bending / axial);
        return axial / (numbers::PI * radius * radius) *
               (axial_strain + outside * curvature.norm());
      }
    };

    /**
     * Return the constants of a full circle of radius @p radius [mm] for the
     * axial modulus E [MPa], the shear modulus G [MPa] and Poisson's ratio.
     * Radius and moduli are positive, the ratio is from 0 to below 0.5; an
     * InputError says which is not. Sections stay plane: the shear factor
     * $k_s$ is 1, and $J = 2 I$. They resist changes of their shape like those
     * of an isotropic fiber, $S = E / (2 (1 + \nu))$, however soft G is.
     */
    Section
    circular_section(const double radius,
                     const double axial_modulus,
                     const double shear_modulus,
                     const double poisson_ratio);

    /**
     * The kernel of one finite element of a fiber. It is told the values of its
     * unknowns as a list of *blocks*, vectors of three numbers: positions,
     * tangents or section vectors, node by node. It knows neither a mesh nor a
     * numbering. It keeps no state: one object serves all elements of all
     * fibers, and the caller owns reference strains and predicted stresses.
     */
    class Element
    {
    public:
      /** Largest number of blocks of any element: cubic, nine unknowns. */
      static constexpr unsigned int max_blocks = 12;

      /** Largest number of strains over all integration points. */
      static constexpr unsigned int max_strains = 36;

      virtual ~Element() = default;

      virtual ElementKind
      kind() const = 0;

      /** What messages and files call it. */
      std::string
      name() const
      {
        return word(kind());
      }

      /** Two, or one more than the polynomial degree for "director". */
      virtual unsigned int
      n_nodes() const = 0;

      /** 2 (position, tangent) or 3 (position, two section vectors). */
      virtual unsigned int
      n_blocks_per_node() const = 0;

      /** Number of strains of one element, over all integration points. */
      virtual unsigned int
      n_strains() const = 0;

      unsigned int
      n_blocks() const
      {
        return n_nodes() * n_blocks_per_node();
      }

      /**
       * Write the strains of an element in the configuration @p blocks, of
       * reference length @p length [mm], into @p strains (n_strains() numbers),
       * reference strains not subtracted.
       */
      virtual void
      strains(const Tensor<1, 3> *blocks,
              const double        length,
              double             *strains) const = 0;

      /**
       * Predict the stresses after the step @p increment of the unknowns,
       * $\sigma = C (\epsilon(u) - \epsilon_0 + B(u) \delta u)$: what the
       * geometric part of the next tangent is built from (Newton with mixed
       * integration points: Magisano, Leonetti and Garcea, 2017).
       */
      virtual void
      predict_stresses(const Section      &section,
                       const Tensor<1, 3> *blocks,
                       const Tensor<1, 3> *increment,
                       const double        length,
                       const double       *reference_strains,
                       double             *stresses) const = 0;

      /**
       * Return the elastic energy [N mm] and, where the pointers are not null,
       * write its gradient into @p residual (3 n_blocks() numbers) and the
       * tangent into @p tangent (row by row, 3 n_blocks() squared). The
       * geometric part of the tangent uses @p predicted_stresses, or the true
       * stresses if that is null; the residual always uses the true ones.
       */
      virtual double
      assemble(const Section      &section,
               const Tensor<1, 3> *blocks,
               const double        length,
               const double       *reference_strains,
               const double       *predicted_stresses,
               double             *residual,
               double             *tangent) const = 0;

      /**
       * Strains, forces and moments in the section at the middle of the
       * element, for output. Moments are conjugate to curvature and twist;
       * forces are those that balance loads: the derivative of the energy by
       * r', along the axis and along the vectors of the section. The slender
       * element has no such vectors: there the first one is what acts across
       * the axis.
       */
      struct SectionState
      {
        double       axial_strain = 0.; /**< [-] */
        Tensor<1, 2> shear_strain;      /**< [-] */
        double       twist = 0.;        /**< [1/mm] */
        Tensor<1, 2> curvature; /**< [1/mm]; first: magnitude if torsion-free */
        double       axial_force = 0.; /**< [N] */
        Tensor<1, 2> shear_force; /**< [N]; first: magnitude if torsion-free */
        double       torque = 0.; /**< [N mm] */
        Tensor<1, 2> bending_moment; /**< [N mm] */
      };

      virtual SectionState
      section_state(const Section      &section,
                    const Tensor<1, 3> *blocks,
                    const double        length,
                    const double       *reference_strains) const = 0;

      /** Elastic energy [N mm], split by the strain that stores it. */
      struct EnergySplit
      {
        double axial   = 0.;
        double bending = 0.;
        double shear   = 0.;
        double torsion = 0.;
        double section = 0.;
      };

      virtual EnergySplit
      energy_split(const Section      &section,
                   const Tensor<1, 3> *blocks,
                   const double        length,
                   const double       *reference_strains) const = 0;

      /**
       * The least of $r' \cdot d$, the direction d being that in which sections
       * or ends point: 1 where nothing is strained, 0 or less in an element
       * that is turned back on itself, whose strains may all be zero [-].
       */
      virtual double
      alignment(const Tensor<1, 3> *blocks, const double length) const = 0;
    };

    /**
     * Return the element of this @p kind and @p degree (1, 2 or 3; ignored by
     * the cubic one). An InputError says what else was found.
     */
    std::unique_ptr<Element>
    make_element(const ElementKind kind, const unsigned int degree);
  } // namespace Beam
} // namespace Heddle

#endif
