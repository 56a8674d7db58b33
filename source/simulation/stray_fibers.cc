#include <heddle/base/yarn_set.h>
#include <heddle/post/crossing_order.h>
#include <heddle/simulation/stray_fibers.h>

#include <algorithm>

namespace Heddle
{
  namespace Simulation
  {
    std::string
    stray_fibers(const std::vector<Textile::FiberPath> &paths,
                 const std::string                     &name)
    {
      std::vector<Polyline> lines;
      for (const Textile::FiberPath &path : paths)
        lines.push_back(path.points);
      std::vector<std::vector<unsigned int>> warp, weft;
      for (const auto &yarn : Textile::fibers_of_yarns(paths))
        if (paths[yarn.second.front()].set == word(YarnSet::warp))
          warp.push_back(yarn.second);
        else if (paths[yarn.second.front()].set == word(YarnSet::weft))
          weft.push_back(yarn.second);

      std::vector<unsigned int> n_strays(paths.size(), 0);
      unsigned int              n_wrong = 0, n_crossings = 0;
      for (const std::vector<unsigned int> &a : warp)
        for (const std::vector<unsigned int> &b : weft)
          {
            Post::OrderedFibers pair{a, b};
            Post::CrossingCount count =
              Post::count_crossing_order(lines, {pair});
            n_crossings += count.total - count.apart;
            if (2 * count.wrong > count.total - count.apart)
              {
                std::swap(pair.upper, pair.lower);
                count = Post::count_crossing_order(lines, {pair});
              }
            n_wrong += count.wrong;
            if (count.wrong == 0)
              continue;
            for (const unsigned int f : pair.upper)
              n_strays[f] +=
                Post::count_crossing_order(lines, {{{f}, pair.lower}}).wrong;
            for (const unsigned int f : pair.lower)
              n_strays[f] +=
                Post::count_crossing_order(lines, {{pair.upper, {f}}}).wrong;
          }
      if (n_wrong == 0)
        return "";
      const auto worst = std::max_element(n_strays.begin(), n_strays.end());
      return name + ": " + std::to_string(n_wrong) + " of " +
             std::to_string(n_crossings) +
             " crossings of fibers are on the other side than most of the "
             "same two yarns, " +
             std::to_string(*worst) + " of them of fiber " +
             std::to_string(worst - n_strays.begin()) +
             " (counted from 0): where points are missing a fiber runs "
             "straight through yarns that it should pass, and where it was "
             "taken for another one it changes yarns, and contact keeps it "
             "there; give it its own points, or leave it out";
    }
  } // namespace Simulation
} // namespace Heddle
