#include <heddle/base/choice.h>
#include <heddle/simulation/centerline_parameters.h>

namespace Heddle
{
  namespace Simulation
  {
    CenterlineParameters::CenterlineParameters(const std::string &section)
      : ParameterAcceptor(section)
    {
      entries.element_length = 1.;
      add_parameter("File",
                    file,
                    "Comma-separated values with the columns "
                    "fiber,x,y,z[,radius][,set][,yarn], one line per point, "
                    "such as the centerlines.csv of another run; semicolons or "
                    "tabs may stand for commas; as seen from "
                    "the folder of the parameter file. Supports and loads find "
                    "fibers by their set; those of the same yarn are measured "
                    "together. No set is named 'none' or, of yarns, 'all', "
                    "'fiber', or as another one with '_inner' behind it. "
                    "A fiber has one radius, the mean of those of "
                    "its points. Inactive if Run/Scene is 'weave', like all of "
                    "this section [-].");
      add_parameter("Element length",
                    entries.element_length,
                    "Every fiber gets the number of equal elements whose "
                    "length is nearest to this [mm].",
                    prm,
                    Patterns::Double(1e-12));
      add_parameter("Radius",
                    entries.radius,
                    "Radius of all fibers; 0: from the column 'radius' [mm].",
                    prm,
                    Patterns::Double(0.));
      add_parameter("Scale",
                    entries.scale,
                    "Size of the file's unit of length, the edge of a voxel "
                    "for instance [mm].",
                    prm,
                    Patterns::Double(1e-12));
      add_choice(*this,
                 "Interpolation",
                 entries.interpolation,
                 "The curve through the points: 'spline' (C2, not curved "
                 "at its ends) or "
                 "'catmull-rom' (C1, and more local) [-].");
      add_parameter("Straight when free",
                    straight_when_free,
                    "Whether the fibers would be straight if they were free, "
                    "and start bent; otherwise the curves of the file are free "
                    "of stress [-].");
      add_parameter("Axial strain",
                    entries.axial_strain,
                    "By how much fibers are longer along these centerlines "
                    "than they would be if they were free, for instance under "
                    "the tension of a fabric. Inactive unless 'Straight when "
                    "free' is true [-].",
                    prm,
                    Patterns::Double(-0.1, 0.1));
    }



    Textile::PathReading
    CenterlineParameters::reading(const unsigned int nodes_per_element) const
    {
      Textile::PathReading result = entries;
      result.knots_per_element    = nodes_per_element - 1;
      // Centerlines are as long as free fibers where these are as curved.
      if (!straight_when_free)
        result.axial_strain = 0.;
      return result;
    }
  } // namespace Simulation
} // namespace Heddle
