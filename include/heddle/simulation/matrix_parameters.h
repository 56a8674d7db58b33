#ifndef heddle_simulation_matrix_parameters_h
#define heddle_simulation_matrix_parameters_h

#include <heddle/solid/material_parameters.h>
#include <heddle/textile/matrix_mesh_parameters.h>

#include <deal.II/base/parameter_acceptor.h>

#include <string>

namespace Heddle
{
  namespace Simulation
  {
    using namespace dealii;

    /** The elastic matrix around the fibers, and how it holds them. */
    class MatrixParameters : public ParameterAcceptor
    {
    public:
      MatrixParameters(const std::string &section = "/Matrix");

      bool                          enabled = false;
      Textile::MatrixMeshParameters mesh;
      unsigned int                  degree = 1;
      Solid::MaterialParameters     material;
      double                        stiffness_factor      = 1.;
      unsigned int                  points_per_element    = 0;
      bool                          subtract_fiber_volume = false;
    };
  } // namespace Simulation
} // namespace Heddle

#endif
