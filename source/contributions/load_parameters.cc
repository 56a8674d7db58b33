#include <heddle/base/exceptions.h>
#include <heddle/base/expression.h>
#include <heddle/contributions/load_parameters.h>

#include <algorithm>

namespace Heddle
{
  namespace Contributions
  {
    bool
    is_nothing(const std::array<std::string, 3> &components)
    {
      return std::all_of(components.begin(),
                         components.end(),
                         [](const std::string &text) { return text == "0"; });
    }



    LoadParameters::LoadParameters(const std::string &section)
      : ParameterAcceptor(section)
    {
      nodes.nodes = ChosenNodes::last_end;
      nodes.add_parameters(*this);
      add_vector("Force",
                 force,
                 "Force on each chosen node, which keeps its direction: a "
                 "formula of the reference position x, y, z [mm] and the load "
                 "factor t. A load without force only has the motion of its "
                 "nodes written to the history [N].");
      add_vector("Moment",
                 moment,
                 "Moment on each chosen node, which keeps its direction: a "
                 "formula like that of the force. With the element 'hermite' "
                 "its part along the axis does nothing [N*mm].");
      add_vector("Force per length",
                 force_per_length,
                 "Force per reference length all along the chosen fibers, "
                 "whatever 'Nodes' says: a formula like that of the force "
                 "[N/mm].");
      parse_parameters_call_back.connect([this]() { check(); });
    }



    void
    LoadParameters::add_vector(const std::string          &name,
                               std::array<std::string, 3> &components,
                               const std::string          &meaning)
    {
      for (unsigned int d = 0; d < 3; ++d)
        add_parameter(name + ' ' + "xyz"[d], components[d], meaning);
    }



    void
    LoadParameters::check() const
    {
      for (unsigned int d = 0; d < 3; ++d)
        {
          Expression(force[d], entry("Force", d));
          Expression(moment[d], entry("Moment", d));
          Expression(force_per_length[d], entry("Force per length", d));
        }
      require(!nodes.is_empty(),
              section_in_words(*this) +
                ": \"Fibers\" is \"none\": this load acts on nothing; name "
                "fibers, or leave the load out.");
    }



    std::string
    LoadParameters::entry(const std::string &name,
                          const unsigned int component) const
    {
      return section_in_words(*this) + ": \"" + name + ' ' + "xyz"[component] +
             "\"";
    }



    LoadList
    declare_loads(const ParameterFile &file)
    {
      LoadList           loads;
      const unsigned int n = file.count_sections("/Loads", "Load");
      for (unsigned int i = 1; i <= n; ++i)
        loads.push_back(
          std::make_unique<LoadParameters>("/Loads/Load " + std::to_string(i)));
      return loads;
    }
  } // namespace Contributions
} // namespace Heddle
