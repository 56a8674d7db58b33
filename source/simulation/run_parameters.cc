#include <heddle/base/choice.h>
#include <heddle/simulation/run_parameters.h>

namespace Heddle
{
  namespace Simulation
  {
    RunParameters::RunParameters(const std::string &section)
      : ParameterAcceptor(section)
    {
      add_choice(*this,
                 "Scene",
                 scene,
                 "'weave': the fabric of section Weave is brought to its "
                 "initial configuration. 'measured fabric': so are the "
                 "fibers of a file, see section Centerlines, which says to "
                 "which yarn each belongs and whether it is of the set "
                 "'warp', along x, or 'weft', along y. 'centerlines': the "
                 "fibers of a file are loaded as section Supports says or, "
                 "without any supports, measured as they are [-].");
      add_parameter("Output directory",
                    output_directory,
                    "Folder of all results, as seen from where the program is "
                    "started; empty: output/NAME for the file NAME.prm [-].");
      add_parameter("Timing",
                    timing,
                    "Whether wall times are printed and written; without "
                    "them, equal runs leave equal files [-].");
      add_parameter("Wall time limit",
                    wall_time_limit,
                    "Stop in order, with a checkpoint, after this time; 0: "
                    "never [s].",
                    prm,
                    Patterns::Double(0.));
    }
  } // namespace Simulation
} // namespace Heddle
