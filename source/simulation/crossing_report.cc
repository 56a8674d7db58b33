#include <heddle/contact/contact_element.h>
#include <heddle/post/crossing_order.h>
#include <heddle/simulation/crossing_report.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

namespace Heddle
{
  namespace Simulation
  {
    namespace
    {
      struct YarnCrossing
      {
        unsigned int a, b;

        /** Where their mean lines pass each other, if they do. */
        std::optional<std::pair<Tensor<1, 3>, Tensor<1, 3>>> met;

        /** What a pattern wants. */
        std::optional<bool> a_on_top_wanted;

        bool
        a_on_top() const
        {
          return met->first[2] > met->second[2];
        }
      };



      /** What presses between two yarns. */
      struct Pressure
      {
        unsigned int n_contacts = 0;
        double       force      = 0.; /**< sum of normal forces [N] */
        double       lift       = 0.; /**< z of those on yarn a [N] */
        double       deepest    = 0.; /**< penetration over radius [-] */
      };



      using Pressures =
        std::map<std::pair<unsigned int, unsigned int>, Pressure>;



      /** Whether it is known what touches: not of fibers that nothing moves. */
      bool
      was_sought(const Scene &scene)
      {
        return scene.contact() != nullptr && scene.contact()->placement() > 0;
      }



      /** Between yarns of all ranks, by their numbers, the smaller one first.
       */
      Pressures
      pressures(const Scene &scene)
      {
        const System::FiberSpace &space = scene.space();
        Pressures                 own;
        unsigned int              last_cell = numbers::invalid_unsigned_int;
        if (was_sought(scene))
          for (const Contact::ContactElement &element :
               scene.contact()->elements())
            {
              const System::Fiber &a = space.fiber(element.fiber_a),
                                  &b = space.fiber(element.fiber_b);
              if (element.force <= 0. || !space.owns(element.fiber_a) ||
                  std::max(a.yarn_id, b.yarn_id) ==
                    numbers::invalid_unsigned_int ||
                  a.yarn_id == b.yarn_id)
                continue;
              const auto yarns    = std::minmax(a.yarn_id, b.yarn_id);
              Pressure  &pressure = own[{yarns.first, yarns.second}];

              // The elements of a cell follow each other.
              pressure.n_contacts += element.cell != last_cell;
              last_cell = element.cell;
              pressure.force += element.force;
              pressure.lift += (a.yarn_id < b.yarn_id ? 1. : -1.) *
                               element.force * element.normal[2];
              pressure.deepest = std::max(
                pressure.deepest, -element.gap / std::min(a.radius, b.radius));
            }

        std::vector<double> rows;
        for (const auto &pair : own)
          rows.insert(rows.end(),
                      {double(pair.first.first),
                       double(pair.first.second),
                       double(pair.second.n_contacts),
                       pair.second.force,
                       pair.second.lift,
                       pair.second.deepest});
        Pressures all;
        for (const auto &of_rank :
             Utilities::MPI::gather(space.communicator(), rows))
          for (auto row = of_rank.begin(); row != of_rank.end(); row += 6)
            {
              Pressure &pressure = all[{static_cast<unsigned int>(row[0]),
                                        static_cast<unsigned int>(row[1])}];
              pressure.n_contacts += static_cast<unsigned int>(row[2]);
              pressure.force += row[3];
              pressure.lift += row[4];
              pressure.deepest = std::max(pressure.deepest, row[5]);
            }
        return all;
      }



      /** Of the pattern of @p weave or, without one, of @p mean_lines. */
      std::vector<YarnCrossing>
      find_crossings(const Textile::Weave                  *weave,
                     const std::vector<FabricReport::Yarn> &yarns,
                     const std::vector<Polyline>           &mean_lines)
      {
        std::vector<YarnCrossing> result;
        const auto                add = [&](const unsigned int        a,
                             const unsigned int        b,
                             const std::optional<bool> wanted) {
          const auto met = Post::crossing_points(mean_lines[a], mean_lines[b]);
          if (met || wanted)
            result.push_back({a, b, met, wanted});
        };
        if (weave != nullptr)
          for (const Textile::Crossing &crossing : weave->crossings())
            add(crossing.warp_yarn, crossing.weft_yarn, crossing.warp_on_top);
        else
          for (unsigned int a = 0; a < mean_lines.size(); ++a)
            for (unsigned int b = a + 1; b < mean_lines.size(); ++b)
              if (yarns[a].set != yarns[b].set)
                add(a, b, {});
        return result;
      }
    } // namespace



    std::string
    crossings_csv(const Scene &scene, const FabricReport &fabric)
    {
      const Pressures pressure_between = pressures(scene);
      const auto     &yarns            = fabric.yarns();
      if (yarns.empty())
        return "";
      std::vector<Polyline> mean_lines;
      for (const FabricReport::Yarn &yarn : yarns)
        mean_lines.push_back(yarn.mean_line());

      std::ostringstream out;
      out.precision(9);
      out << "yarn_a[-],yarn_b[-],x[mm],y[mm],z_a[mm],z_b[mm],a_on_top[-],"
             "a_on_top_wanted[-],fiber_pairs[-],fiber_pairs_wrong[-],"
             "fiber_pairs_apart[-],contacts[-],contact_force[N],"
             "contact_force_z_on_a[N],max_penetration_ratio[-]\n";
      for (const YarnCrossing &crossing :
           find_crossings(scene.weave(), yarns, mean_lines))
        {
          const unsigned int a = crossing.a, b = crossing.b;
          out << a << ',' << b;
          if (crossing.met)
            out << ',' << crossing.met->first[0] << ','
                << crossing.met->first[1] << ',' << crossing.met->first[2]
                << ',' << crossing.met->second[2] << ',' << crossing.a_on_top();
          else
            out << ",,,,,";
          out << ',';
          if (crossing.a_on_top_wanted)
            out << *crossing.a_on_top_wanted;
          Post::OrderedFibers pair{yarns[a].fibers, yarns[b].fibers};
          if (!(crossing.a_on_top_wanted ? *crossing.a_on_top_wanted
                                         : crossing.a_on_top()))
            std::swap(pair.upper, pair.lower);
          const Post::CrossingCount count =
            Post::count_crossing_order(fabric.centerlines(), {pair});
          out << ',' << count.total << ',' << count.wrong << ',' << count.apart
              << ',';
          if (was_sought(scene))
            {
              const auto     found = pressure_between.find({a, b});
              const Pressure pressure =
                found == pressure_between.end() ? Pressure() : found->second;
              out << pressure.n_contacts << ',' << pressure.force << ','
                  << pressure.lift << ',' << pressure.deepest << '\n';
            }
          else
            out << ",,,\n";
        }
      return out.str();
    }
  } // namespace Simulation
} // namespace Heddle
