#ifndef heddle_simulation_inactive_parameters_h
#define heddle_simulation_inactive_parameters_h

#include <heddle/base/parameter_file.h>

#include <string>
#include <vector>

namespace Heddle
{
  namespace Simulation
  {
    /**
     * Return what @p file sets to no effect, other than parameters are by
     * themselves, and why: one sentence for each reason, such as
     * "scene.prm:12 and 2 others set what has no effect, for Matrix/Enabled is
     * false". The parameters have been given the values of this file.
     */
    std::vector<std::string>
    inactive_parameters(const ParameterFile &file);
  } // namespace Simulation
} // namespace Heddle

#endif
