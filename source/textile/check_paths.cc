#include <heddle/base/exceptions.h>
#include <heddle/textile/check_paths.h>

#include <algorithm>
#include <string>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      /** Axes closer to each other than this part of the radius are one. */
      constexpr double same = 1e-6;



      bool
      coincide(const FiberPath &a, const FiberPath &b)
      {
        const auto agree = [&a](const auto begin, const auto end) {
          return std::equal(a.points.begin(),
                            a.points.end(),
                            begin,
                            end,
                            [&a](const Tensor<1, 3> &p, const Tensor<1, 3> &q) {
                              return (p - q).norm() < same * a.radius;
                            });
        };
        return agree(b.points.begin(), b.points.end()) ||
               agree(b.points.rbegin(), b.points.rend());
      }
    } // namespace



    void
    check_paths(const std::vector<FiberPath> &paths)
    {
      // Both ends together lie at the same place along a line through space,
      // in which direction a fiber may run. The line is one that fabrics and
      // grids have no symmetry to.
      const Tensor<1, 3>                           line({0.62, 0.53, 0.58});
      std::vector<std::pair<double, unsigned int>> order;
      for (unsigned int f = 0; f < paths.size(); ++f)
        order.push_back(
          {line * (paths[f].points.front() + paths[f].points.back()), f});
      std::sort(order.begin(), order.end());
      for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size(); ++j)
          {
            const FiberPath &a = paths[order[i].second],
                            &b = paths[order[j].second];
            if (order[j].first - order[i].first > 4. * same * a.radius)
              break;
            require(
              !coincide(a, b),
              "Fibers " +
                std::to_string(std::min(order[i].second, order[j].second)) +
                " and " +
                std::to_string(std::max(order[i].second, order[j].second)) +
                " (from 0) lie in the same place: remove one of them "
                "or, in a weave, raise the spacing of yarns or fibers.");
          }
    }
  } // namespace Textile
} // namespace Heddle
