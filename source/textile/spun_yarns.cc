#include <heddle/base/yarn_reach.h>
#include <heddle/textile/spun_yarns.h>

#include <map>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      /** The yarns in which no fiber runs from end to end, by their number. */
      std::map<unsigned int, YarnReach>
      find_spun(const std::vector<FiberPath> &paths)
      {
        std::map<unsigned int, std::vector<Polyline>> yarns;
        for (const FiberPath &path : paths)
          if (path.yarn_id != no_id)
            yarns[path.yarn_id].push_back(path.points);
        std::map<unsigned int, YarnReach> spun;
        for (const auto &yarn : yarns)
          {
            const YarnReach reach(yarn.second);
            if (reach.is_spun())
              spun.emplace(yarn.first, reach);
          }
        return spun;
      }
    } // namespace



    std::vector<std::array<bool, 2>>
    ends_of_yarns(const std::vector<FiberPath> &paths)
    {
      const std::map<unsigned int, YarnReach> spun = find_spun(paths);
      std::map<unsigned int, unsigned int>    n_before;
      std::vector<std::array<bool, 2>>        ends;
      for (const FiberPath &path : paths)
        {
          const auto yarn = spun.find(path.yarn_id);
          ends.push_back(yarn == spun.end() ? std::array<bool, 2>{{true, true}}
                                            : yarn->second.ends_with_yarn(
                                                n_before[path.yarn_id]++));
        }
      return ends;
    }



    std::string
    spun_yarns(const std::vector<FiberPath> &paths, const std::string &name)
    {
      const std::map<unsigned int, YarnReach> spun = find_spun(paths);
      if (spun.empty())
        return "";
      return name + ": no fiber runs from end to end of yarn " +
             std::to_string(spun.begin()->first) + " (counted from 0)" +
             (spun.size() == 1
                ? ""
                : ", like " + std::to_string(spun.size() - 1) + " others") +
             ": it is taken for one that is spun of staple fibers, whose ends "
             "within a measured fabric are free, so that only friction or a "
             "matrix holds it together";
    }
  } // namespace Textile
} // namespace Heddle
