#include <heddle/post/fabric_sheet.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Heddle
{
  namespace Post
  {
    namespace
    {
      /** Names of sets in the order in which they appear. */
      std::vector<std::string>
      names_of_sets(const std::vector<YarnBody> &yarns)
      {
        std::vector<std::string> names;
        for (const YarnBody &yarn : yarns)
          if (std::find(names.begin(), names.end(), yarn.set) == names.end())
            names.push_back(yarn.set);
        return names;
      }



      /** The yarns of two sets; none if there are fewer or more. */
      std::array<std::vector<YarnBody>, 2>
      two_sets(const std::vector<YarnBody> &yarns)
      {
        std::array<std::vector<YarnBody>, 2> sets;
        const auto                           names = names_of_sets(yarns);
        if (names.size() == 2)
          for (const YarnBody &yarn : yarns)
            sets[yarn.set == names[1]].push_back(yarn);
        return sets;
      }



      void
      add_tensor(const std::string             &of_set,
                 const FiberOrientation        &orientation,
                 std::map<std::string, double> &results)
      {
        if (orientation.weight() == 0.)
          return;
        const SymmetricTensor<2, 3> a = orientation.tensor();
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = i; j < 3; ++j)
            results[of_set + "orientation_" + "xyz"[i] + "xyz"[j] + "[-]"] =
              a[i][j];
      }
    } // namespace



    FabricSheet::FabricSheet(const std::vector<YarnBody> &yarns)
      : window(two_sets(yarns))
      , lowest(std::numeric_limits<double>::max())
      , highest(-lowest)
    {
      for (const std::string &name : names_of_sets(yarns))
        {
          sets.emplace_back();
          sets.back().name = name;
        }
      if (window.found())
        for (unsigned int d = 0; d < 2; ++d)
          sets[d].area = window.area(d);
      for (const YarnBody &yarn : yarns)
        for (unsigned int f = 0; f < yarn.lines.size(); ++f)
          {
            is_weighed &= yarn.densities[f] > 0.;
            for (unsigned int i = 0; i + 1 < yarn.lines[f].size(); ++i)
              add_piece(yarn, f, yarn.lines[f][i], yarn.lines[f][i + 1]);
          }
      if (window.found())
        for (const YarnBody &yarn : yarns)
          add_crimp(yarn);
    }



    unsigned int
    FabricSheet::number_of(const std::string &name) const
    {
      return std::find_if(
               sets.begin(),
               sets.end(),
               [&name](const Set &set) { return set.name == name; }) -
             sets.begin();
    }



    void
    FabricSheet::add_piece(const YarnBody     &yarn,
                           const unsigned int  f,
                           const Tensor<1, 3> &a,
                           const Tensor<1, 3> &b)
    {
      const unsigned int d      = number_of(yarn.set);
      const double       radius = yarn.radii[f];
      const auto         part   = window.found() ? window.part_between(d, a, b)
                                                 : std::pair<double, double>(0., 1.);
      if (part.second <= part.first)
        return;
      const Tensor<1, 3> piece  = (part.second - part.first) * (b - a);
      const double       volume = numbers::PI * radius * radius * piece.norm();
      sets[d].orientation.add(piece, volume);
      sets[d].mass += yarn.densities[f] * volume;
      for (const double end : {part.first, part.second})
        {
          const Tensor<1, 3> point = a + end * (b - a);
          // Fibers of the outer yarns lie on both sides of their axes.
          if (window.found() && !window.is_between(1 - d, point, radius))
            continue;
          lowest  = std::min(lowest, point[2] - radius);
          highest = std::max(highest, point[2] + radius);
        }
    }



    void
    FabricSheet::add_crimp(const YarnBody &yarn)
    {
      const unsigned int d   = number_of(yarn.set);
      double             way = 0.;
      for (unsigned int i = 0; i + 1 < yarn.mean.size(); ++i)
        {
          const Tensor<1, 3> &a = yarn.mean[i], &b = yarn.mean[i + 1];
          const auto          part = window.part_between(d, a, b);
          if (part.second <= part.first)
            continue;
          const Tensor<1, 3> piece = (part.second - part.first) * (b - a);
          sets[d].length += piece.norm();
          way += window.component(d, piece);
        }
      // Yarns may run either way.
      sets[d].way += std::abs(way);
    }



    void
    FabricSheet::add_to(std::map<std::string, double> &results) const
    {
      results["thickness[mm]"] = thickness();
      add_tensor("", of_all(), results);
      for (const Set &set : sets)
        if (!set.name.empty())
          add_tensor(set.name + "_", set.orientation, results);
      if (!window.found())
        return;

      double mass_per_area = 0.;
      for (unsigned int d = 0; d < 2; ++d)
        {
          const std::string of_set =
            sets[d].name.empty() ? "" : sets[d].name + "_";
          results[of_set + "spacing[mm]"] = window.spacing(d);
          results[of_set + "inner_crimp[-]"] =
            sets[d].length / sets[d].way - 1.;
          mass_per_area += sets[d].mass / sets[d].area;
        }
      results["fiber_volume_fraction[-]"] = volume_fraction();
      // 1 mm g/cm^3 is 1000 g/m^2.
      if (is_weighed)
        results["areal_weight[g/m^2]"] = 1000. * mass_per_area;
    }



    double
    FabricSheet::volume_fraction() const
    {
      return window.found() ? of_all().weight() / thickness() : 0.;
    }



    FiberOrientation
    FabricSheet::of_all() const
    {
      FiberOrientation all;
      for (const Set &set : sets)
        all.add(set.orientation, set.area > 0. ? 1. / set.area : 1.);
      return all;
    }



    std::string
    FabricSheet::orientation_csv() const
    {
      std::vector<std::string>      names;
      std::vector<FiberOrientation> columns;
      for (const Set &set : sets)
        if (!set.name.empty() && set.orientation.weight() > 0.)
          {
            names.push_back(set.name);
            columns.push_back(set.orientation);
          }
      names.push_back("all");
      columns.push_back(of_all());

      std::ostringstream out;
      out.precision(6);
      out << "angle[-],from[deg],to[deg]";
      for (const std::string &name : names)
        out << ',' << name << "[-]";
      out << '\n';
      const auto add = [&out](const std::string                      &angle,
                              const double                            lowest,
                              const std::vector<std::vector<double>> &parts) {
        for (unsigned int i = 0; i < parts[0].size(); ++i)
          {
            const double from = lowest + i * FiberOrientation::step;
            out << angle << ',' << from << ',' << from + FiberOrientation::step;
            for (const std::vector<double> &column : parts)
              out << ',' << column[i];
            out << '\n';
          }
      };
      std::vector<std::vector<double>> steep, turned;
      for (const FiberOrientation &column : columns)
        {
          steep.push_back(column.out_of_plane());
          turned.push_back(column.in_plane());
        }
      add("out of plane", 0., steep);
      add("in plane", FiberOrientation::lowest, turned);
      return out.str();
    }
  } // namespace Post
} // namespace Heddle
