#ifndef heddle_simulation_run_parameters_h
#define heddle_simulation_run_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <string>

namespace Heddle
{
  namespace Simulation
  {
    using namespace dealii;

    /** What a scene is made of. */
    enum class SceneKind
    {
      weave,           /**< laid out from a description */
      measured_fabric, /**< from a file */
      centerlines      /**< fibers from a file */
    };

    /** How the user names them. */
    constexpr const char *
    word(const SceneKind kind)
    {
      switch (kind)
        {
          case SceneKind::weave:
            return "weave";
          case SceneKind::measured_fabric:
            return "measured fabric";
          case SceneKind::centerlines:
            return "centerlines";
        }
      return nullptr;
    }



    /** What is computed, and where it goes. */
    class RunParameters : public ParameterAcceptor
    {
    public:
      RunParameters(const std::string &section = "/Run");

      /** Whether fibers come from a file, and not from a weave. */
      bool
      is_from_file() const
      {
        return scene != SceneKind::weave;
      }

      /** Whether there are warp and weft, which settle before a load. */
      bool
      is_fabric() const
      {
        return scene != SceneKind::centerlines;
      }

      SceneKind   scene            = SceneKind::weave;
      std::string output_directory = "";
      bool        timing           = true;
      double      wall_time_limit  = 0.;
    };
  } // namespace Simulation
} // namespace Heddle

#endif
