#include <heddle/base/yarn_reach.h>
#include <heddle/base/yarn_set.h>
#include <heddle/post/centerline.h>
#include <heddle/post/fabric_sheet.h>
#include <heddle/post/yarn_section.h>
#include <heddle/simulation/fabric_report.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace Heddle
{
  namespace Simulation
  {
    namespace
    {
      /** Straight pieces between two nodes, and points of a mean line at
       * least. */
      constexpr unsigned int n_pieces = 4, n_mean_points = 201;

      /** Volume fraction of what is nothing but fibers, a single one for
       * instance, with what chords make of a bend [-]. */
      constexpr double full = 1.01;



      double
      length_of(const Polyline &line)
      {
        double length = 0.;
        for (unsigned int i = 0; i + 1 < line.size(); ++i)
          length += (line[i + 1] - line[i]).norm();
        return length;
      }



      /** Section number @p i of @p n, and none of them at an end. */
      double
      station(const unsigned int i, const unsigned int n)
      {
        return (i + 0.5) / n;
      }
    } // namespace



    FabricReport::FabricReport(const System::State &state,
                               const PointMap      &flattened)
      : space(state.space)
      , lines(Post::gather_centerlines(state, n_pieces))
      , all_yarns(lines.empty() ? 0 : state.space.n_yarns())
    {
      for (unsigned int f = 0; f < lines.size(); ++f)
        {
          move_points(lines[f], flattened);
          const System::Fiber &fiber = state.space.fiber(f);
          if (fiber.yarn_id == numbers::invalid_unsigned_int)
            continue;
          Yarn &yarn = all_yarns[fiber.yarn_id];
          yarn.set   = fiber.set;
          yarn.fibers.push_back(f);
          yarn.lines.push_back(lines[f]);
          yarn.radii.push_back(fiber.radius);
        }
    }



    Polyline
    FabricReport::Yarn::mean_line() const
    {
      std::size_t n = n_mean_points;
      for (const Polyline &fiber : lines)
        n = std::max(n, fiber.size());
      return Heddle::mean_line(lines, n);
    }



    std::string
    FabricReport::yarns_csv(const unsigned int n_stations) const
    {
      std::ostringstream out;
      out.precision(9);
      out << "yarn[-],is_warp[-],station[-],x[mm],y[mm],z[mm],width[mm],"
             "height[mm],aspect_ratio[-],hull_area[mm^2],fiber_area[mm^2],"
             "volume_fraction[-],fibers_missing[-],crimp[-]\n";
      for (unsigned int y = 0; y < all_yarns.size(); ++y)
        {
          const auto mean = all_yarns[y].mean_line();
          for (unsigned int i = 0; i < n_stations; ++i)
            {
              const double fraction = station(i, n_stations);
              const auto   section  = Post::cut_yarn(all_yarns[y].lines,
                                                  all_yarns[y].radii,
                                                  plane_at(mean, fraction));
              out << y << ',' << (all_yarns[y].set == word(YarnSet::warp))
                  << ',' << fraction;
              const Tensor<1, 3> &x = section.center;
              for (const double value : {x[0],
                                         x[1],
                                         x[2],
                                         section.width,
                                         section.height,
                                         section.aspect_ratio(),
                                         section.hull_area,
                                         section.fiber_area,
                                         section.volume_fraction()})
                {
                  // Where no fiber passes there is nothing to measure.
                  out << ',';
                  if (!section.points.empty())
                    out << value;
                }
              out << ',' << section.n_missing << ',' << crimp(mean) << '\n';
            }
        }
      return out.str();
    }



    std::map<std::string, double>
    FabricReport::results(const unsigned int         n_stations,
                          const std::vector<double> &densities) const
    {
      std::map<std::string, double>                          result;
      std::map<std::string, std::pair<double, unsigned int>> sums;
      const auto add = [&sums](const std::string &name, const double value) {
        sums[name].first += value;
        ++sums[name].second;
      };
      for (const Yarn &yarn : all_yarns)
        {
          const std::string of_set = yarn.set.empty() ? "" : yarn.set + "_";
          const auto        mean   = yarn.mean_line();
          const bool        spun   = YarnReach(yarn.lines).is_spun();
          add(of_set + "crimp[-]", crimp(mean));
          for (unsigned int i = 0; i < n_stations; ++i)
            {
              // Near the ends of a yarn some of its fibers may be missing; one
              // that is spun never has all.
              const auto section = Post::cut_yarn(
                yarn.lines, yarn.radii, plane_at(mean, station(i, n_stations)));
              if (section.points.empty() || (section.n_missing > 0 && !spun))
                continue;
              add(of_set + "aspect_ratio[-]", section.aspect_ratio());
              add(of_set + "volume_fraction[-]", section.volume_fraction());
            }
        }
      for (const auto &sum : sums)
        result[sum.first] = sum.second.first / sum.second.second;
      if (!all_yarns.empty())
        Post::FabricSheet(bodies(densities)).add_to(result);
      return result;
    }



    std::string
    FabricReport::orientation_csv() const
    {
      return Post::FabricSheet(bodies({})).orientation_csv();
    }



    std::string
    FabricReport::overfull(const unsigned int n_stations) const
    {
      if (all_yarns.empty())
        return "";
      std::ostringstream text;
      text << std::setprecision(3);
      const double overall = Post::FabricSheet(bodies({})).volume_fraction();
      if (overall > full)
        text << "the fabric has a volume fraction of " << overall;
      unsigned int n_full = 0, worst_yarn = 0;
      double       largest = full, worst_station = 0.;
      for (unsigned int y = 0; y < all_yarns.size(); ++y)
        {
          const Polyline mean = all_yarns[y].mean_line();
          for (unsigned int i = 0; i < n_stations; ++i)
            {
              const double fraction = station(i, n_stations);
              const double found    = Post::cut_yarn(all_yarns[y].lines,
                                                  all_yarns[y].radii,
                                                  plane_at(mean, fraction))
                                     .volume_fraction();
              n_full += found > full;
              if (found > largest)
                {
                  largest       = found;
                  worst_yarn    = y;
                  worst_station = fraction;
                }
            }
        }
      if (n_full > 0)
        text << (overall > full ? ", and " : "") << n_full << " of "
             << n_stations * all_yarns.size()
             << " sections of yarns have one above 1, up to " << largest
             << " of yarn " << worst_yarn << " at station " << worst_station;
      if (text.str().empty())
        return "";
      text << ": fibers lie in each other, or pass the section aslant, or "
              "their radius is too large";
      return text.str();
    }



    std::vector<Post::YarnBody>
    FabricReport::bodies(const std::vector<double> &densities) const
    {
      std::vector<Post::YarnBody> result;
      for (const Yarn &yarn : all_yarns)
        {
          result.push_back(
            {yarn.set, yarn.lines, yarn.radii, {}, yarn.mean_line()});
          // What a fiber weighs it keeps when it is stretched.
          for (const unsigned int f : yarn.fibers)
            result.back().densities.push_back(
              densities.empty()
                ? 0.
                : densities[f] * space.fiber(f).length / length_of(lines[f]));
        }
      return result;
    }
  } // namespace Simulation
} // namespace Heddle
