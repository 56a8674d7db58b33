#include <heddle/base/exceptions.h>
#include <heddle/simulation/parameters.h>

#include <sstream>

namespace Heddle
{
  namespace Simulation
  {
    Parameters::Parameters(const ParameterFile &file)
      : supports(Contributions::declare_supports(file))
      , loads(Contributions::declare_loads(file))
    {
      file.apply();
    }



    void
    Parameters::check(const ParameterFile &file) const
    {
      const bool        weaves = run.scene == "weave";
      const std::string wanted = weaves ? "Weave" : "Centerlines";
      const std::string other  = weaves ? "Centerlines" : "Weave";
      require(!file.mentions("/" + other),
              file.name() + ": there is a section \"" + other +
                "\", but Run/Scene is \"" + run.scene +
                "\": change that, or remove the section.");
      require(file.mentions("/" + wanted),
              file.name() +
                ": the scene is empty; describe it in a section \"" + wanted +
                "\".");
      require(weaves || !centerlines.file.empty(),
              file.name() + ": Centerlines/File is empty; name the file of the "
                            "centerlines.");
      for (const std::string section : {"Supports", "Loads", "Load stepping"})
        require(!weaves || !file.mentions("/" + section),
                file.name() + ": the section \"" + section +
                  "\" is for Run/Scene = centerlines; remove it.");
      require(weaves || !file.mentions("/Initial configuration"),
              file.name() + ": the section \"Initial configuration\" is for "
                            "Run/Scene = weave; remove it.");
      require(weaves || !supports.empty(),
              file.name() + ": nothing holds the fibers; declare a section "
                            "\"Supports/Support 1\".");
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
