#include <heddle/base/settings.h>
#include <heddle/simulation/inactive_parameters.h>
#include <heddle/simulation/parameters.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace Heddle
{
  namespace Simulation
  {
    namespace
    {
      /** Which values of a parameter let others be in force. */
      struct Values
      {
        std::vector<std::string> values;
        bool                     are_in_force; /**< these, or all other ones */
      };



      std::string
      text_of(const char *const text)
      {
        return text;
      }



      template <typename Choice>
      std::string
      text_of(const Choice value)
      {
        return word(value);
      }



      template <typename... Value>
      Values
      is(const Value... value)
      {
        return {{text_of(value)...}, true};
      }



      template <typename... Value>
      Values
      is_not(const Value... value)
      {
        return {{text_of(value)...}, false};
      }



      /** What is in force only if another parameter is what it says. In the
       * name of a section # stands for each number. */
      struct Rule
      {
        std::vector<std::string> paths; /**< parameters, or all of sections */
        std::string              depends_on;
        Values                   needed;
      };



      /** As the parameters' documentation says; the first that fails counts. */
      const std::vector<Rule> rules = {
        {{"Weave"}, "Run/Scene", is(SceneKind::weave)},
        {{"Initial configuration", "Restart/Stress free"},
         "Run/Scene",
         is_not(SceneKind::centerlines)},
        {{"Initial configuration/Axial tension",
          "Initial configuration/Axial tension of weft",
          "Initial configuration/Guide stiffness",
          "Initial configuration/Friction",
          "Initial configuration/Ordering"},
         "Restart/Initial configuration",
         is("")},
        {{"Centerlines"}, "Run/Scene", is_not(SceneKind::weave)},
        {{"Centerlines/Axial strain"},
         "Centerlines/Straight when free",
         is("true")},
        {{"Weave/Crimp factor", "Weave/Crimp transition"},
         "Weave/Start",
         is(Textile::Start::crimped)},
        {{"Weave/Weft yarns"},
         "Weave/Weft yarns/Same as warp yarns",
         is("false")},
        {{"Weave/Warp yarns/Packing seed"},
         "Weave/Warp yarns/Packing perturbation",
         is_not("0")},
        {{"Weave/Weft yarns/Packing seed"},
         "Weave/Weft yarns/Packing perturbation",
         is_not("0")},
        {{"Fiber/Elements per fiber"}, "Run/Scene", is(SceneKind::weave)},
        {{"Contact"}, "Contact/Enabled", is("true")},
        {{"Initial configuration/Ordering"},
         "Weave/Start",
         is(Textile::Start::interpenetrating)},
        {{"Matrix", "Output/Matrix"}, "Matrix/Enabled", is("true")},
        {{"Output/Subdivisions"}, "Output/Fibers", is("true")},
        {{"Output/Centerlines"}, "Output/Interval", is_not("0")},
        {{"Output/Checkpoints kept"},
         "Output/Checkpoint interval",
         is_not("0")},
        {{"Matrix/Overlap depth"},
         "Matrix/Leave out cells inside yarns",
         is("true")},
        {{"Matrix/Lower corner", "Matrix/Upper corner"},
         "Matrix/Shape",
         is(Textile::MatrixShape::block)},
        {{"Fabric loading"}, "Fabric loading/Kind", is_not(FabricTest::none)},
        {{"Fabric loading/Strain"},
         "Fabric loading/Kind",
         is(FabricTest::biaxial_tension, FabricTest::uniaxial_tension)},
        {{"Fabric loading/Strain ratios"},
         "Fabric loading/Kind",
         is(FabricTest::biaxial_tension)},
        {{"Fabric loading/Direction", "Fabric loading/Sides"},
         "Fabric loading/Kind",
         is(FabricTest::uniaxial_tension, FabricTest::bending)},
        {{"Fabric loading/Curvature", "Fabric loading/Grip"},
         "Fabric loading/Kind",
         is(FabricTest::bending)},
        {{"Fabric loading/Grip"}, "Matrix/Enabled", is("false")},
        {{"Fabric loading/Ends"},
         "Fabric loading/Kind",
         is_not(FabricTest::bending)},
        {{"Fabric loading/Shear angles", "Fabric loading/Yarn ends"},
         "Fabric loading/Kind",
         is(FabricTest::picture_frame, FabricTest::simple_shear)},
        {{"Fabric loading/Yarn ends"}, "Matrix/Enabled", is("true")},
        {{"Fabric loading/Ramp"},
         "Fabric loading/Kind",
         is_not(FabricTest::held)},
        {{"Linear solver/Tolerance", "Linear solver/Maximum iterations"},
         "Linear solver/Kind",
         is_not(Solver::LinearSolverKind::direct)},
        {{"Linear solver/Direct below",
          "Linear solver/Direct below in a matrix",
          "Linear solver/Direct below with contact"},
         "Linear solver/Kind",
         is(Solver::LinearSolverKind::automatic)},
        {{"Matrix/Link sections",
          "Fiber/Degree",
          "Fiber/Shear modulus",
          "Fiber/Torsional stiffness",
          "Fiber/Shear stiffness",
          "Fiber/Section stiffness",
          "Fiber/Material #/Shear modulus",
          "Fiber/Material #/Torsional stiffness",
          "Fiber/Material #/Shear stiffness",
          "Fiber/Material #/Section stiffness"},
         "Fiber/Element",
         is(Beam::ElementKind::director)},
        {{"Supports/Support #/Point", "Supports/Support #/Distance"},
         "Supports/Support #/Nodes",
         is(Contributions::ChosenNodes::near_point)},
        {{"Supports/Support #/Turn angle", "Supports/Support #/Turn axis"},
         "Supports/Support #/Section",
         is(Contributions::SupportedSection::turned)},
        {{"Loads/Load #/Point", "Loads/Load #/Distance"},
         "Loads/Load #/Nodes",
         is(Contributions::ChosenNodes::near_point)}};



      /** The same of one parameter or section. */
      struct Condition
      {
        std::string path;
        std::string depends_on;
        Values      needed;
      };



      /** The value in force of the parameter @p path. */
      std::string
      value_of(const std::string &path)
      {
        auto              parts = Utilities::split_string_list(path, '/');
        const std::string name  = parts.back();
        parts.pop_back();
        return ParameterAcceptor::prm.get(parts, name);
      }



      bool
      is_met(const Condition &condition)
      {
        const std::string value  = value_of(condition.depends_on);
        const auto       &values = condition.needed.values;
        const bool        listed = std::any_of(
          values.begin(), values.end(), [&value](const std::string &one) {
            return same_value(one, value);
          });
        return listed == condition.needed.are_in_force;
      }



      /** Add the condition, for each section of @p file that # stands for. */
      void
      add_conditions(const ParameterFile    &file,
                     const Condition        &condition,
                     std::vector<Condition> &conditions)
      {
        const auto place = condition.path.find('#');
        if (place == std::string::npos)
          {
            conditions.push_back(condition);
            return;
          }
        const auto         slash = condition.path.find('/');
        const unsigned int n     = file.count_sections(
          condition.path.substr(0, slash),
          condition.path.substr(slash + 1, place - slash - 2));
        for (unsigned int i = 1; i <= n; ++i)
          {
            const auto numbered = [i](const std::string &path) {
              return Utilities::replace_in_string(path, "#", std::to_string(i));
            };
            conditions.push_back({numbered(condition.path),
                                  numbered(condition.depends_on),
                                  condition.needed});
          }
      }



      std::vector<Condition>
      all_conditions(const ParameterFile &file)
      {
        std::vector<Condition> conditions;
        for (const Rule &rule : rules)
          for (const std::string &path : rule.paths)
            add_conditions(
              file, {path, rule.depends_on, rule.needed}, conditions);
        if (value_of("Contact/Friction of sets").empty())
          for (const std::string path : {"Contact/Friction of crossed fibers",
                                         "Contact/Reversible displacement",
                                         "Initial configuration/Friction"})
            conditions.push_back(
              {path, "Contact/Friction coefficient", is_not("0")});
        // Plates have a threshold of penetration and are damped, too.
        if (value_of("Plates/Compression") != "0")
          conditions.erase(std::remove_if(conditions.begin(),
                                          conditions.end(),
                                          [](const Condition &condition) {
                                            return condition.depends_on ==
                                                   "Contact/Enabled";
                                          }),
                           conditions.end());
        if (file.count_sections("Supports", "Support") == 0 &&
            file.count_sections("Loads", "Load") == 0)
          conditions.push_back(
            {"Load stepping", "Fabric loading/Kind", is_not(FabricTest::none)});
        return conditions;
      }



      /** Whether the parameter @p path is what the condition is for. */
      bool
      is_about(const Condition &condition, const std::string &path)
      {
        const std::string section = condition.path + "/";
        return path == condition.path ||
               path.compare(0, section.size(), section) == 0;
      }



      /** "small.prm:9 and 1 other set what has no effect, for ..." */
      std::string
      sentence(const std::string &where,
               const unsigned int n_more,
               const Condition   &condition)
      {
        return where +
               (n_more == 0
                  ? " sets "
                  : " and " + std::to_string(n_more) +
                      (n_more == 1 ? " other" : " others") + " set ") +
               "what has no effect, for " + condition.depends_on + " is " +
               value_of(condition.depends_on);
      }
    } // namespace



    std::vector<std::string>
    inactive_parameters(const ParameterFile &file)
    {
      std::vector<ParameterFile::Entry> entries =
        file.unusual(ParameterAcceptor::prm);
      std::vector<std::string> sentences;
      for (const Condition &condition : all_conditions(file))
        {
          if (is_met(condition))
            continue;
          const auto idle = std::stable_partition(
            entries.begin(), entries.end(), [&](const auto &entry) {
              return !is_about(condition, entry.path) ||
                     entry.path == condition.depends_on;
            });
          if (idle == entries.end())
            continue;
          sentences.push_back(
            sentence(idle->where, entries.end() - idle - 1, condition));
          entries.erase(idle, entries.end());
        }
      return sentences;
    }
  } // namespace Simulation
} // namespace Heddle
