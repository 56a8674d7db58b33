#ifndef heddle_solid_material_parameters_h
#define heddle_solid_material_parameters_h

#include <heddle/solid/material.h>

#include <deal.II/base/parameter_acceptor.h>

namespace Heddle
{
  namespace Solid
  {
    /** What keeps cells from locking where their volume hardly changes. */
    enum class LockingRemedy
    {
      automatic, /**< the one below for degree 1 */
      mean_dilatation,
      none
    };

    /** How the user names them. */
    constexpr const char *
    word(const LockingRemedy remedy)
    {
      switch (remedy)
        {
          case LockingRemedy::automatic:
            return "automatic";
          case LockingRemedy::mean_dilatation:
            return "mean dilatation";
          case LockingRemedy::none:
            return "none";
        }
      return nullptr;
    }



    /** What a user may say about the material of the matrix. */
    struct MaterialParameters
    {
      MaterialLaw   law            = MaterialLaw::linear;
      double        youngs_modulus = 1.; /**< [MPa] */
      double        poisson_ratio  = 0.3;
      LockingRemedy locking_remedy = LockingRemedy::automatic;

      /** Declare the entries in the section of @p owner. */
      void
      add_parameters(ParameterAcceptor &owner);

      /** Return the law; an InputError says which constant is none. */
      std::unique_ptr<Material>
      material() const;

      /**
       * Whether cells of the polynomial degree @p degree have one dilatation.
       * InputError if that is asked of degree 2: a free cell would have three
       * modes without energy beside rigid motions.
       */
      bool
      has_mean_dilatation(const unsigned int degree) const;
    };
  } // namespace Solid
} // namespace Heddle

#endif
