#include <heddle/base/choice.h>
#include <heddle/base/exceptions.h>
#include <heddle/solid/material_parameters.h>

namespace Heddle
{
  namespace Solid
  {
    void
    MaterialParameters::add_parameters(ParameterAcceptor &owner)
    {
      add_choice(
        owner,
        "Law",
        law,
        "Elastic law: 'linear' for small strains and small rotations, 'st "
        "venant-kirchhoff' for small strains and any rotations, 'neo-hookean' "
        "for large strains [-].");
      owner.add_parameter("Youngs modulus",
                          youngs_modulus,
                          "Young's modulus at small strains, above 0 [MPa].",
                          ParameterAcceptor::prm,
                          Patterns::Double(0.));
      owner.add_parameter("Poisson ratio",
                          poisson_ratio,
                          "Poisson's ratio at small strains, above -1 and "
                          "below 0.5 [-].",
                          ParameterAcceptor::prm,
                          Patterns::Double(-1., .5));
      add_choice(
        owner,
        "Locking remedy",
        locking_remedy,
        "Whether cells have one mean dilatation, so that they can bend though "
        "their volume hardly changes: needed by cells of degree 1 with a "
        "Poisson ratio above 0.4 or so, and for these only. 'automatic' takes "
        "it "
        "for degree 1 [-].");
    }



    std::unique_ptr<Material>
    MaterialParameters::material() const
    {
      return make_material(law, youngs_modulus, poisson_ratio);
    }



    bool
    MaterialParameters::has_mean_dilatation(const unsigned int degree) const
    {
      switch (locking_remedy)
        {
          case LockingRemedy::automatic:
            return degree == 1;
          case LockingRemedy::mean_dilatation:
            require(degree == 1,
                    "The locking remedy \"mean dilatation\" is for cells of "
                    "degree 1; choose \"automatic\" or \"none\" for degree " +
                      std::to_string(degree) + ".");
            return true;
          case LockingRemedy::none:
            return false;
        }
      Assert(false, ExcInternalError());
      return false;
    }
  } // namespace Solid
} // namespace Heddle
