#include <heddle/simulation/restart_parameters.h>

namespace Heddle
{
  namespace Simulation
  {
    RestartParameters::RestartParameters(const std::string &section)
      : ParameterAcceptor(section)
    {
      add_parameter("Initial configuration",
                    initial_configuration,
                    "Folder of results, or file, from which the initial "
                    "configuration of a fabric is taken instead of being "
                    "computed; ranks, friction, matrix and loads may be others "
                    "there. Its path begins where the program is started. "
                    "A file of 'checkpoint' of a dry fabric under load will "
                    "do as well, unless it is sheared or bent: forces go on "
                    "from there, and strains count from there. "
                    "Of section 'Initial configuration' the last penetration "
                    "threshold alone has an effect then. Empty: compute it "
                    "[-].");
      add_parameter("Stress free",
                    stress_free,
                    "Whether fibers are free of stress, and of contact forces, "
                    "in the initial configuration of a fabric from which they "
                    "are loaded. If not, they keep what they have. Needs the "
                    "element 'director': without torsion a curved fiber that "
                    "is free of stress turns in its place. Inactive if "
                    "Run/Scene is 'centerlines' [-].");
    }
  } // namespace Simulation
} // namespace Heddle
