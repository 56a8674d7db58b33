#include <heddle/base/mean_line.h>
#include <heddle/base/number_text.h>
#include <heddle/textile/gaps_in_bends.h>

#include <algorithm>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      /** How far @p line bends off its chord between planes across a gap [mm];
       * 0 if it does not reach over all of it. */
      double
      bend_over(const std::array<Tensor<1, 3>, 2> &gap, const Polyline &line)
      {
        // The outermost planes lie within the gap, for fibers of a yarn end at
        // places that differ.
        constexpr unsigned int n_planes = 8;
        const Tensor<1, 3>     along    = gap[1] - gap[0];
        Polyline               places;
        for (unsigned int i = 0; i < n_planes; ++i)
          {
            const Passage passage = pass_through(
              line,
              {gap[0] + (i + 0.5) / n_planes * along, along / along.norm()});
            if (!passage.found)
              return 0.;
            places.push_back(passage.point);
          }
        const Tensor<1, 3> chord = places.back() - places.front();
        double             bend  = 0.;
        for (const Tensor<1, 3> &place : places)
          bend =
            std::max(bend,
                     cross_product_3d(place - places.front(), chord).norm() /
                       chord.norm());
        return bend;
      }



      /** Mean line of the fibers of a yarn, without that of number @p left_out
       * if it has one. */
      Polyline
      line_of(const std::vector<FiberPath>    &paths,
              const std::vector<unsigned int> &yarn,
              const unsigned int               left_out)
      {
        std::vector<Polyline> lines;
        std::size_t           n_points = 0;
        for (const unsigned int f : yarn)
          if (f != left_out)
            {
              lines.push_back(paths[f].points);
              n_points = std::max(n_points, lines.back().size());
            }
        return mean_line(lines, n_points);
      }
    } // namespace



    std::string
    gaps_in_bends(const std::vector<FiberPath> &paths, const std::string &name)
    {
      unsigned int n_fibers = 0, worst = 0;
      double       most = 0.;
      for (const auto &yarn : fibers_of_yarns(paths))
        {
          // The fiber itself says nothing there, but has a part in the mean.
          const double n = yarn.second.size();
          if (n < 2)
            continue;
          const Polyline line = line_of(paths, yarn.second, no_id);
          for (const unsigned int f : yarn.second)
            {
              if (n / (n - 1.) * bend_over(paths[f].gap, line) <=
                  paths[f].radius)
                continue;
              const double bend =
                bend_over(paths[f].gap, line_of(paths, yarn.second, f)) /
                paths[f].radius;
              n_fibers += bend > 1.;
              if (bend > most)
                {
                  most  = bend;
                  worst = f;
                }
            }
        }
      if (n_fibers == 0)
        return "";
      return name + ": two points of fiber " + std::to_string(worst) +
             " (counted from 0) that follow each other are " +
             number_text((paths[worst].gap[1] - paths[worst].gap[0]).norm(),
                         3) +
             " mm apart, where its yarn bends by " + number_text(most, 2) +
             " of its radii off the straight line" +
             (n_fibers == 1   ? ""
              : n_fibers == 2 ? ", and so it is with another one"
                              : ", and so it is with " +
                                  std::to_string(n_fibers - 1) + " others") +
             ": between them the fiber is a guess, and may run through those "
             "that its yarn passes; give points there, or leave it out";
    }
  } // namespace Textile
} // namespace Heddle
