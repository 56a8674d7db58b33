#ifndef heddle_simulation_parameters_h
#define heddle_simulation_parameters_h

#include <heddle/base/parameter_file.h>
#include <heddle/contact/contact_parameters.h>
#include <heddle/contributions/load_parameters.h>
#include <heddle/contributions/plate_parameters.h>
#include <heddle/contributions/support_parameters.h>
#include <heddle/io/output_parameters.h>
#include <heddle/simulation/centerline_parameters.h>
#include <heddle/simulation/fabric_loading_parameters.h>
#include <heddle/simulation/fiber_parameters.h>
#include <heddle/simulation/matrix_parameters.h>
#include <heddle/simulation/ordering_stage.h>
#include <heddle/simulation/restart_parameters.h>
#include <heddle/simulation/run_parameters.h>
#include <heddle/simulation/settle_parameters.h>
#include <heddle/solver/load_stepping.h>
#include <heddle/solver/newton.h>
#include <heddle/textile/weave_parameters.h>

#include <string>

namespace Heddle
{
  namespace Simulation
  {
    /** All sections of a parameter file, in the order of the story. */
    class Parameters
    {
    public:
      /** Declare the sections and give them the values of @p file. */
      explicit Parameters(const ParameterFile &file);

      /** Whether anything holds the fibers. */
      bool
      are_held() const
      {
        return fabric_loading.is_active() || !supports.empty();
      }

      /** Whether a load or a support turns sections of fibers. */
      bool
      turn_sections() const;

      /** Throw InputError if @p file describes no scene, or another one. */
      void
      check(const ParameterFile &file) const;

      /** All parameters with their meaning, as a parameter file. */
      static std::string
      text();

      RunParameters                  run;
      Textile::WeaveParameters       weave;
      CenterlineParameters           centerlines;
      FiberParameters                fiber;
      Contact::ContactParameters     contact;
      SettleParameters               settle;
      OrderingParameters             ordering;
      RestartParameters              restart;
      MatrixParameters               matrix;
      FabricLoadingParameters        fabric_loading;
      Contributions::SupportList     supports;
      Contributions::LoadList        loads;
      Contributions::PlateParameters plates;
      Solver::LoadSteppingParameters load_stepping;
      Solver::NewtonParameters       newton;
      Solver::LinearSolverParameters linear_solver;
      IO::OutputParameters           output;

    private:
      /** Parts of check(). */
      void
      check_fabric_loading(const ParameterFile &file) const;

      void
      check_restart(const ParameterFile &file) const;

      void
      check_matrix(const ParameterFile &file) const;
    };
  } // namespace Simulation
} // namespace Heddle

#endif
