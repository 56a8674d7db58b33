#include <heddle/base/choice.h>
#include <heddle/simulation/matrix_parameters.h>

namespace Heddle
{
  namespace Simulation
  {
    MatrixParameters::MatrixParameters(const std::string &section)
      : ParameterAcceptor(section)
    {
      add_parameter("Enabled",
                    enabled,
                    "Whether the fibers are embedded in an elastic matrix when "
                    "they are loaded. If not, no other entry of this section "
                    "is active [-].");
      mesh.add_parameters(*this);
      add_parameter("Degree",
                    degree,
                    "Polynomial degree of the hexahedra [-].",
                    prm,
                    Patterns::Integer(1, 2));
      material.add_parameters(*this);
      add_parameter("Coupling stiffness factor",
                    stiffness_factor,
                    "Stiffness of the links between fibers and matrix per "
                    "length of fiber, in units of the matrix' modulus. 1 is a "
                    "bond as soft as the matrix, after the paper; the larger, "
                    "the stiffer the composite, with gripped yarns in shear "
                    "above all: try 10 as well before a result is taken for "
                    "one of the material [-].",
                    prm,
                    Patterns::Double(1e-6));
      add_parameter("Coupling points per element",
                    points_per_element,
                    "Links in each element of a fiber; 0: one in each node, "
                    "and two in the part of an interval between nodes that "
                    "leaves the matrix [-].",
                    prm,
                    Patterns::Integer(0, 5));
      add_choice(*this,
                 "Link sections",
                 section_links,
                 "Whether links also resist that fibers turn about their axes "
                 "in the matrix, which grips their surfaces: by their "
                 "stiffness at the distance of a radius. Otherwise they hold "
                 "axes only, as in the paper, and a straight fiber turns for "
                 "nothing. 'automatic': if a load has a moment or a support "
                 "turns sections; in fabrics that are pulled or sheared it "
                 "changes forces by some 0.1 %. Inactive for 'hermite' [-].");
      add_parameter("Subtract fiber volume",
                    subtract_fiber_volume,
                    "Whether cells of the matrix count without the volume of "
                    "the fibers in them. If not, matrix and fibers are both "
                    "there [-].");
    }
  } // namespace Simulation
} // namespace Heddle
