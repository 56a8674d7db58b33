#include <heddle/base/settings.h>
#include <heddle/simulation/inactive_parameters.h>
#include <heddle/simulation/parameters.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <set>

namespace Heddle
{
  namespace Simulation
  {
    namespace
    {
      /** What is not in force unless another parameter has a certain value. */
      struct Condition
      {
        std::string              path; /**< a parameter, or all of a section */
        std::string              depends_on;
        std::vector<std::string> values;            /**< any of these, or ... */
        bool                     but_these = false; /**< ... any other one */
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



      /** Of the numbered sections of supports or of loads. */
      void
      add_numbered(const ParameterFile    &file,
                   const std::string      &list,
                   const std::string      &name,
                   std::vector<Condition> &conditions)
      {
        const unsigned int n = file.count_sections(list, name);
        for (unsigned int i = 1; i <= n; ++i)
          {
            const std::string one =
              list + "/" + name + " " + std::to_string(i) + "/";
            for (const std::string entry : {"Point", "Distance"})
              conditions.push_back(
                {one + entry,
                 one + "Nodes",
                 {word(Contributions::ChosenNodes::near_point)}});
            if (name == "Support")
              for (const std::string entry : {"Turn angle", "Turn axis"})
                conditions.push_back(
                  {one + entry,
                   one + "Section",
                   {word(Contributions::SupportedSection::turned)}});
          }
      }



      /** As the parameters' documentation says; the first that fails counts. */
      std::vector<Condition>
      all_conditions(const ParameterFile &file)
      {
        std::vector<Condition> conditions = {
          {"Weave", "Run/Scene", {word(SceneKind::weave)}},
          {"Initial configuration",
           "Run/Scene",
           {word(SceneKind::centerlines)},
           true},
          {"Initial configuration", "Restart/Initial configuration", {""}},
          {"Centerlines", "Run/Scene", {word(SceneKind::weave)}, true},
          {"Centerlines/Axial strain",
           "Centerlines/Straight when free",
           {"true"}},
          {"Weave/Crimp factor",
           "Weave/Start",
           {word(Textile::Start::crimped)}},
          {"Weave/Crimp transition",
           "Weave/Start",
           {word(Textile::Start::crimped)}},
          {"Weave/Weft yarns",
           "Weave/Weft yarns/Same as warp yarns",
           {"false"}},
          {"Weave/Warp yarns/Packing seed",
           "Weave/Warp yarns/Packing perturbation",
           {"0"},
           /*but_these=*/true},
          {"Weave/Weft yarns/Packing seed",
           "Weave/Weft yarns/Packing perturbation",
           {"0"},
           true},
          {"Fiber/Elements per fiber", "Run/Scene", {word(SceneKind::weave)}},
          {"Contact", "Contact/Enabled", {"true"}},
          {"Newton/Damping", "Contact/Enabled", {"true"}},
          {"Initial configuration/Ordering",
           "Weave/Start",
           {word(Textile::Start::interpenetrating)}},
          {"Matrix", "Matrix/Enabled", {"true"}},
          {"Output/Matrix", "Matrix/Enabled", {"true"}},
          {"Output/Subdivisions", "Output/Fibers", {"true"}},
          {"Output/Centerlines", "Output/Interval", {"0"}, true},
          {"Output/Checkpoints kept",
           "Output/Checkpoint interval",
           {"0"},
           true},
          {"Matrix/Overlap depth",
           "Matrix/Leave out cells inside yarns",
           {"true"}},
          {"Matrix/Lower corner",
           "Matrix/Shape",
           {word(Textile::MatrixShape::block)}},
          {"Matrix/Upper corner",
           "Matrix/Shape",
           {word(Textile::MatrixShape::block)}},
          {"Fabric loading",
           "Fabric loading/Kind",
           {word(FabricTest::none)},
           true},
          {"Fabric loading/Strain",
           "Fabric loading/Kind",
           {word(FabricTest::biaxial_tension),
            word(FabricTest::uniaxial_tension)}},
          {"Fabric loading/Strain ratios",
           "Fabric loading/Kind",
           {word(FabricTest::biaxial_tension)}},
          {"Fabric loading/Direction",
           "Fabric loading/Kind",
           {word(FabricTest::uniaxial_tension)}},
          {"Fabric loading/Sides",
           "Fabric loading/Kind",
           {word(FabricTest::uniaxial_tension)}},
          {"Fabric loading/Shear angles",
           "Fabric loading/Kind",
           {word(FabricTest::picture_frame), word(FabricTest::simple_shear)}},
          {"Fabric loading/Ramp",
           "Fabric loading/Kind",
           {word(FabricTest::none), word(FabricTest::held)},
           true},
          {"Linear solver/Tolerance",
           "Linear solver/Kind",
           {word(Solver::LinearSolverKind::direct)},
           true},
          {"Linear solver/Maximum iterations",
           "Linear solver/Kind",
           {word(Solver::LinearSolverKind::direct)},
           true},
          {"Linear solver/Direct below",
           "Linear solver/Kind",
           {word(Solver::LinearSolverKind::automatic)}},
          {"Linear solver/Direct below in a matrix",
           "Linear solver/Kind",
           {word(Solver::LinearSolverKind::automatic)}},
          {"Linear solver/Direct below with contact",
           "Linear solver/Kind",
           {word(Solver::LinearSolverKind::automatic)}}};
        conditions.push_back({"Fiber/Degree",
                              "Fiber/Element",
                              {word(Beam::ElementKind::director)}});
        std::vector<std::string> materials = {"Fiber/"};
        const unsigned int       n_materials =
          file.count_sections("Fiber", "Material");
        for (unsigned int i = 1; i <= n_materials; ++i)
          materials.push_back("Fiber/Material " + std::to_string(i) + "/");
        for (const std::string &material : materials)
          for (const std::string entry : {"Shear modulus",
                                          "Torsional stiffness",
                                          "Shear stiffness",
                                          "Section stiffness"})
            conditions.push_back({material + entry,
                                  "Fiber/Element",
                                  {word(Beam::ElementKind::director)}});
        if (value_of("Contact/Friction of sets").empty())
          for (const std::string path : {"Contact/Friction of crossed fibers",
                                         "Contact/Reversible displacement",
                                         "Initial configuration/Friction"})
            conditions.push_back(
              {path, "Contact/Friction coefficient", {"0"}, true});
        if (file.count_sections("Supports", "Support") == 0 &&
            file.count_sections("Loads", "Load") == 0)
          conditions.push_back({"Load stepping",
                                "Fabric loading/Kind",
                                {word(FabricTest::none)},
                                true});
        add_numbered(file, "Supports", "Support", conditions);
        add_numbered(file, "Loads", "Load", conditions);
        return conditions;
      }
    } // namespace



    std::vector<std::string>
    inactive_parameters(const ParameterFile &file)
    {
      std::vector<ParameterFile::Entry> entries =
        file.unusual(ParameterAcceptor::prm);
      std::set<std::string> paths;
      for (const ParameterFile::Entry &entry : entries)
        paths.insert(entry.path);
      std::vector<std::string> sentences;
      for (const Condition &condition : all_conditions(file))
        {
          // Most are about what no file sets.
          const auto first = paths.lower_bound(condition.path);
          if (first == paths.end() ||
              first->compare(0, condition.path.size(), condition.path) != 0)
            continue;
          const std::string value  = value_of(condition.depends_on);
          const bool        listed = std::any_of(condition.values.begin(),
                                          condition.values.end(),
                                          [&value](const std::string &one) {
                                            return same_value(one, value);
                                          });
          if (listed != condition.but_these)
            continue;

          const auto idle = std::stable_partition(
            entries.begin(), entries.end(), [&](const auto &entry) {
              const bool within = entry.path == condition.path ||
                                  entry.path.compare(0,
                                                     condition.path.size() + 1,
                                                     condition.path + "/") == 0;
              return !within || entry.path == condition.depends_on;
            });
          if (idle == entries.end())
            continue;
          const auto more = entries.end() - idle - 1;
          sentences.push_back(
            idle->where +
            (more == 0 ? " sets "
                       : " and " + std::to_string(more) +
                           (more == 1 ? " other" : " others") + " set ") +
            "what has no effect, for " + condition.depends_on + " is " + value);
          entries.erase(idle, entries.end());
        }
      return sentences;
    }
  } // namespace Simulation
} // namespace Heddle
