#ifndef heddle_solid_material_h
#define heddle_solid_material_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <memory>

namespace Heddle
{
  namespace Solid
  {
    using namespace dealii;

    /** Elastic laws of a matrix. */
    enum class MaterialLaw
    {
      linear,              /**< small strains and rotations */
      st_venant_kirchhoff, /**< small strains */
      neo_hookean          /**< large strains */
    };

    /** How the user names them. */
    constexpr const char *
    word(const MaterialLaw law)
    {
      switch (law)
        {
          case MaterialLaw::linear:
            return "linear";
          case MaterialLaw::st_venant_kirchhoff:
            return "st venant-kirchhoff";
          case MaterialLaw::neo_hookean:
            return "neo-hookean";
        }
      return nullptr;
    }



    /**
     * An isotropic elastic law. Its energy density in the deformation gradient
     * F [N/mm^2] is
     * $$ W(F) = W_s(F) + U(\theta(F)), $$
     * the energy of the shape and that of the dilatation $\theta$: so one
     * remedy against volumetric locking, which replaces $\theta$ in U by its
     * mean over a cell, serves all laws. Shear modulus $\mu = E / 2(1 + \nu)$
     * and bulk modulus $K = E / 3(1 - 2\nu)$ are those of small strains.
     */
    class Material
    {
    public:
      /**
       * Second derivative of an energy density in F: the number 9 (3 i + J) +
       * 3 k + L is that in F_iJ and F_kL.
       */
      using Tangent = std::array<double, 81>;

      /** U, the first derivative and the second one, in the dilatation. */
      struct Volume
      {
        double energy;   /**< [MPa] */
        double pressure; /**< [MPa], positive in tension */
        double modulus;  /**< [MPa] */
      };

      /** Moduli are in MPa. */
      Material(const double shear_modulus, const double bulk_modulus)
        : shear_modulus(shear_modulus)
        , bulk_modulus(bulk_modulus)
      {
      }

      virtual ~Material() = default;

      /** Of small strains in one direction, without any in others [MPa]. */
      double
      longitudinal_modulus() const
      {
        return bulk_modulus + 4. / 3. * shear_modulus;
      }

      virtual MaterialLaw
      law() const = 0;

      /** Whether strains are small ones, and the tangent is constant. */
      virtual bool
      is_linear() const = 0;

      /**
       * Whether @p F is a state of matter: det F > 0, and any F for small
       * strains. The other members must not be asked where it is not.
       */
      virtual bool
      is_admissible(const Tensor<2, 3> &F) const;

      /**
       * Return the energy of the shape $W_s$ [MPa]; where the pointers are not
       * null write its first and its second derivative in F.
       */
      virtual double
      shape(const Tensor<2, 3> &F,
            Tensor<2, 3>       *stress,
            Tangent            *tangent) const = 0;

      /** Return $\theta$ [-] and write its derivative in F to @p gradient. */
      virtual double
      dilatation(const Tensor<2, 3> &F, Tensor<2, 3> &gradient) const = 0;

      /** Add @p factor times the second derivative of $\theta$ in F. */
      virtual void
      add_dilatation_tangent(const Tensor<2, 3> &F,
                             const double        factor,
                             Tangent            &tangent) const = 0;

      /** Return U with its derivatives. */
      virtual Volume
      volume(const double dilatation) const = 0;

      /**
       * Return the Cauchy stress [MPa] at @p F if the cell has the
       * @p dilatation. For small strains it is the stress.
       */
      SymmetricTensor<2, 3>
      cauchy_stress(const Tensor<2, 3> &F, const double dilatation) const;

      /**
       * Return the strain of Green and Lagrange, $\frac12(F^T F - I)$, or for
       * the linear law the small one, $\mathrm{sym} F - I$.
       */
      SymmetricTensor<2, 3>
      strain(const Tensor<2, 3> &F) const;

    protected:
      const double shear_modulus;
      const double bulk_modulus;
    };

    /** Return $\sqrt{3/2\; s : s}$ of the deviator s of @p stress. */
    double
    von_mises(const SymmetricTensor<2, 3> &stress);

    /**
     * Return the @p law for Young's modulus @p youngs_modulus [MPa] and
     * Poisson's ratio. The modulus is positive, the
     * ratio between -1 and 0.5; an InputError says what else was found.
     */
    std::unique_ptr<Material>
    make_material(const MaterialLaw law,
                  const double      youngs_modulus,
                  const double      poisson_ratio);
  } // namespace Solid
} // namespace Heddle

#endif
