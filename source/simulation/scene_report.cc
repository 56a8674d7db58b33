#include <heddle/base/exceptions.h>
#include <heddle/post/bend.h>
#include <heddle/simulation/energy_balance.h>
#include <heddle/simulation/matrix.h>
#include <heddle/simulation/scene.h>

#include <algorithm>
#include <set>

namespace Heddle
{
  namespace Simulation
  {
    std::map<std::string, double>
    Scene::report(const unsigned int stage) const
    {
      std::map<std::string, double> values;
      if (parameters.matrix.enabled && !composite)
        for (const char *name : {"matrix_energy[N*mm]",
                                 "coupling_energy[N*mm]",
                                 "coupling_elements[-]",
                                 "largest_coupling_force_per_length[N/mm]"})
          values[name] = 0.;
      std::set<std::string> reported;
      const auto            report_those_of = [&](const Stage &one) {
        for (const auto &contribution : one.contributions)
          if (reported.insert(contribution->name()).second)
            add_report(*contribution, values);
      };
      if (stage < all_stages.size())
        report_those_of(all_stages[stage]);
      for (const Stage &other : all_stages)
        report_those_of(other);
      values["max_bend_ratio[-]"] = Post::sharpest_bend(*configuration).ratio;
      return values;
    }



    void
    Scene::add_report(const System::Contribution    &contribution,
                      std::map<std::string, double> &values) const
    {
      std::map<std::string, double> more;
      contribution.report(*configuration, more);
      for (const auto &value : more)
        if (value.first == EnergyBalance::external_work)
          values[value.first] += value.second;
        else
          require(values.insert(value).second,
                  "The contribution \"" + contribution.name() +
                    "\" reports \"" + value.first +
                    "\", as another one does; give that another name.");
    }



    std::vector<std::string>
    Scene::contribution_names() const
    {
      std::vector<std::string> names;
      for (const Stage &stage : all_stages)
        for (const auto &contribution : stage.contributions)
          if (std::find(names.begin(), names.end(), contribution->name()) ==
              names.end())
            names.push_back(contribution->name());
      if (parameters.matrix.enabled && !composite)
        names.insert(names.end(),
                     {"matrix elasticity", "fiber-matrix coupling"});
      return names;
    }
  } // namespace Simulation
} // namespace Heddle
