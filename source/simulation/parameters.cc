#include <heddle/base/exceptions.h>
#include <heddle/simulation/parameters.h>

#include <sstream>

namespace Heddle
{
  namespace Simulation
  {
    Parameters::Parameters(const ParameterFile &file)
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
      if (weaves)
        {
          require(!file.mentions("/Load stepping"),
                  file.name() + ": \"Load stepping\" is for Run/Scene = "
                                "centerlines; a weave has no loads yet.");
          settle.thresholds(contact.threshold);
        }
      else
        {
          require(!file.mentions("/Initial configuration"),
                  file.name() + ": \"Initial configuration\" is for Run/Scene "
                                "= weave; remove the section.");
          load_stepping.plan();
        }
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
