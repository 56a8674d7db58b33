#include <heddle/base/yarn_reach.h>
#include <heddle/textile/lost_fibers.h>

#include <algorithm>

namespace Heddle
{
  namespace Textile
  {
    std::string
    lost_fibers(const std::vector<FiberPath> &paths, const std::string &name)
    {
      std::vector<unsigned int> lost;
      for (const auto &yarn : fibers_of_yarns(paths))
        {
          std::vector<Polyline> lines;
          for (const unsigned int f : yarn.second)
            lines.push_back(paths[f].points);
          for (const unsigned int i : YarnReach(lines).short_fibers())
            lost.push_back(yarn.second[i]);
        }
      if (lost.empty())
        return "";
      return name + ": fiber " +
             std::to_string(*std::min_element(lost.begin(), lost.end())) +
             " (counted from 0)" +
             (lost.size() == 1 ? " ends"
              : lost.size() == 2
                ? " and another one end"
                : " and " + std::to_string(lost.size() - 1) + " others end") +
             " more than a tenth of the yarn's length from its end: the mean "
             "line and the crimp of the yarn leave it out, means of sections "
             "are of those that all fibers reach, and what holds its ends "
             "grips it in the middle of the yarn; trace it to the end, or "
             "leave it out";
    }
  } // namespace Textile
} // namespace Heddle
