#include <heddle/base/exceptions.h>
#include <heddle/contact/contact_parameters.h>

namespace Heddle
{
  namespace Contact
  {
    ContactParameters::ContactParameters(const std::string &section)
      : ParameterAcceptor(section)
    {
      add_parameter("Enabled",
                    enabled,
                    "Whether fibers keep each other, and themselves, out. If "
                    "not, no other entry of this section is active [-].");
      add_parameter(
        "Penetration threshold",
        threshold,
        "Largest penetration of two fibers that is accepted, as a "
        "part of the smaller radius. Penalties are adapted in every "
        "proximity zone until it is met [-].",
        prm,
        Patterns::Double(1e-4, 0.2));
      add_parameter("Search distance",
                    given_search_distance,
                    "Surfaces closer than this are watched for contact, as a "
                    "multiple of the largest radius. A larger one means fewer "
                    "searches and more to watch; no step moves a fiber by more "
                    "than 0.35 of it, nor of the sum of its radius and that of "
                    "the thinnest fiber beside it. 0: 2 for fabrics, else 1 "
                    "[-].",
                    prm,
                    Patterns::Double(0., 4.));
      add_parameter("Refinement",
                    refinement,
                    "Number of contact cells in one interval between the nodes "
                    "of a fiber; where fibers cross there are more [-].",
                    prm,
                    Patterns::Double(0.25, 16.));
      add_parameter("Friction coefficient",
                    friction,
                    "Largest tangential force over the normal force of two "
                    "fibers; 0: no friction, and nothing is computed for it "
                    "[-].",
                    prm,
                    Patterns::Double(0., 2.));
      add_parameter(
        "Friction of sets",
        friction_of_sets,
        "Coefficients of pairs of materials that differ from the "
        "one above, as in 'warp-warp: 0.1, warp-weft: 0.2': sets "
        "are 'warp' and 'weft', or those of the file of "
        "centerlines [-].",
        prm,
        Patterns::Map(Patterns::Anything(), Patterns::Double(0., 2.)));
      add_parameter("Friction of crossed fibers",
                    crossed_friction,
                    "Coefficient of fibers that cross at a right angle over "
                    "that of parallel ones; between them it changes with the "
                    "squared cosine of the angle. Inactive without friction "
                    "[-].",
                    prm,
                    Patterns::Double(0., 10.));
      add_parameter("Reversible displacement",
                    reversible_displacement,
                    "Tangential displacement, as a part of the smaller radius, "
                    "that two fibers take back before they slip. Inactive "
                    "without friction [-].",
                    prm,
                    Patterns::Double(1e-4, 1.));
    }



    void
    ContactParameters::choose_for(const bool fabric)
    {
      constexpr double least = 0.1;
      require(given_search_distance == 0. || given_search_distance >= least,
              "Contact/Search distance is smaller than 0.1: fibers would "
              "hardly move in an iteration; raise it, or leave it out.");
      search_distance = given_search_distance > 0. ? given_search_distance
                        : fabric                   ? 2.
                                                   : 1.;
    }



    bool
    ContactParameters::has_friction() const
    {
      for (const auto &pair : friction_of_sets)
        if (pair.second > 0.)
          return true;
      return friction > 0.;
    }
  } // namespace Contact
} // namespace Heddle
