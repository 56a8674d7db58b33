#include <heddle/base/exceptions.h>
#include <heddle/simulation/parameters.h>
#include <heddle/textile/matrix_grid.h>

#include <algorithm>
#include <sstream>

namespace Heddle
{
  namespace Simulation
  {
    Parameters::Parameters(const ParameterFile &file)
      : supports(Contributions::declare_supports(file))
      , loads(Contributions::declare_loads(file))
    {
      fiber.materials = declare_materials(file);
      file.apply();
      contact.choose_for(run.is_fabric());
      newton.choose_for(run.is_fabric(), centerlines.straight_when_free);
    }



    void
    Parameters::check(const ParameterFile &file) const
    {
      const bool        weaves = !run.is_from_file();
      const std::string wanted = weaves ? "Weave" : "Centerlines";
      const std::string other  = weaves ? "Centerlines" : "Weave";
      require(file.mentions("/" + wanted) || !file.mentions("/" + other),
              file.name() + ": there is a section \"" + other +
                "\", but Run/Scene is \"" + word(run.scene) +
                "\": change that.");
      require(file.mentions("/" + wanted),
              file.name() +
                ": the scene is empty; describe it in a section \"" + wanted +
                "\".");
      require(weaves == centerlines.file.empty(),
              file.name() +
                (weaves ? ": Centerlines/File is given, but Run/Scene is "
                          "\"weave\": remove one of them."
                        : ": Centerlines/File is empty; name the file of the "
                          "centerlines."));
      require(run.is_fabric() || restart.initial_configuration.empty(),
              file.name() +
                ": Restart/Initial configuration is given, but Run/Scene is "
                "\"centerlines\": only a weave and a measured fabric have an "
                "initial configuration.");
      check_fabric_loading(file);
      check_restart(file);
      check_matrix(file);
      require(are_held() || loads.empty(),
              file.name() + ": nothing holds the fibers against the loads; "
                            "declare a section \"Supports/Support 1\".");
    }



    void
    Parameters::check_fabric_loading(const ParameterFile &file) const
    {
      require(run.is_fabric() || !fabric_loading.is_active(),
              file.name() +
                ": Fabric loading/Kind is given, but Run/Scene is "
                "\"centerlines\": only a weave and a measured fabric have four "
                "sides to move; declare sections \"Supports/Support 1\" and so "
                "on instead.");
      require(!fabric_loading.is_active() ||
                (supports.empty() && loads.empty()),
              file.name() +
                ": Fabric loading/Kind is given, and so are sections "
                "\"Supports\" or \"Loads\": remove one of them, since the "
                "loading of a fabric moves all of its sides itself.");
      require(
        !fabric_loading.leaves_yarns_free() || matrix.enabled ||
          (contact.enabled && contact.has_friction()),
        file.name() +
          ": Fabric loading/Sides is \"free\", but nothing keeps the yarns "
          "between these sides from being drawn out; set "
          "\"Contact/Friction coefficient\", enable the matrix, or set "
          "\"Sides\" to \"held\".");
      require(!fabric_loading.bends() || !plates.are_there(),
              file.name() +
                ": Fabric loading/Kind is \"bending\", and Plates/Compression "
                "is given: plates stay level; remove one of them.");
    }



    void
    Parameters::check_restart(const ParameterFile &file) const
    {
      require(are_held() || restart.initial_configuration.empty(),
              file.name() +
                ": Restart/Initial configuration is given, but nothing holds "
                "the fibers, so there is nothing to compute; set "
                "\"Fabric loading/Kind\", or declare a section "
                "\"Supports/Support 1\".");
      require(!restart.stress_free ||
                fiber.element_kind == Beam::ElementKind::director,
              file.name() +
                ": Restart/Stress free is true, but Fiber/Element is \"" +
                word(fiber.element_kind) +
                "\", which knows no torsion: a curved fiber that is free of "
                "stress would turn in its place without resistance; choose "
                "\"director\".");
    }



    void
    Parameters::check_matrix(const ParameterFile &file) const
    {
      require(are_held() || !matrix.enabled,
              file.name() +
                ": Matrix/Enabled is true, but nothing holds fibers or matrix, "
                "so there is nothing to compute in it; set "
                "\"Fabric loading/Kind\", or declare a section "
                "\"Supports/Support 1\".");
      if (matrix.enabled)
        {
          matrix.material.material();
          matrix.material.has_mean_dilatation(matrix.degree);
          Textile::check_description(matrix.mesh.description(), "Matrix");
        }
      require(are_held() || !plates.are_there(),
              file.name() +
                ": Plates/Compression is given, but nothing holds the fibers "
                "between the plates; set \"Fabric loading/Kind\", to \"held\" "
                "for instance, or declare a section \"Supports/Support 1\".");
      require(
        !matrix.enabled || !plates.are_there(),
        file.name() +
          ": Plates/Compression is given, but Matrix/Enabled is true: "
          "plates press on fibers alone; move the sides \"z-, z+\" of the "
          "matrix by a section \"Supports/Support 1\" instead.");
      for (const auto &support : supports)
        require(matrix.enabled || support->matrix_sides.empty(),
                support->entry("Matrix sides") +
                  " names sides, but Matrix/Enabled is false: leave them out, "
                  "or enable the matrix.");
    }



    bool
    Parameters::turn_sections() const
    {
      return std::any_of(loads.begin(),
                         loads.end(),
                         [](const auto &load) { return load->has_moment(); }) ||
             std::any_of(
               supports.begin(), supports.end(), [](const auto &support) {
                 return support->section ==
                        Contributions::SupportedSection::turned;
               });
    }



    std::string
    Parameters::text()
    {
      std::ostringstream out;
      ParameterAcceptor::prm.print_parameters(
        out, ParameterHandler::PRM | ParameterHandler::KeepDeclarationOrder);
      return out.str();
    }
  } // namespace Simulation
} // namespace Heddle
