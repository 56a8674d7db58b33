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

    /** Where a matrix resists that sections turn about the axis of a fiber. */
    enum class SectionLinks
    {
      automatic, /**< everywhere, if anything turns sections */
      always,
      never
    };

    /** How the user names them. */
    constexpr const char *
    word(const SectionLinks links)
    {
      switch (links)
        {
          case SectionLinks::automatic:
            return "automatic";
          case SectionLinks::always:
            return "always";
          case SectionLinks::never:
            return "never";
        }
      return nullptr;
    }



    /** The elastic matrix around the fibers, and how it holds them. */
    class MatrixParameters : public ParameterAcceptor
    {
    public:
      MatrixParameters(const std::string &section = "/Matrix");

      bool                          enabled = false;
      Textile::MatrixMeshParameters mesh;
      unsigned int                  degree = 1;
      Solid::MaterialParameters     material;
      double                        stiffness_factor   = 1.;
      unsigned int                  points_per_element = 0;
      SectionLinks                  section_links = SectionLinks::automatic;
      bool                          subtract_fiber_volume = false;
    };
  } // namespace Simulation
} // namespace Heddle

#endif
