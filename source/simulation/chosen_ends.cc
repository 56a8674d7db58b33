#include <heddle/base/yarn_reach.h>
#include <heddle/simulation/chosen_ends.h>

#include <algorithm>
#include <iomanip>
#include <map>
#include <sstream>

namespace Heddle
{
  namespace Simulation
  {
    namespace internal
    {
      namespace ChosenEnds
      {
        using Contributions::ChosenNodes;

        /** Fibers of a set at less than this cosine to each other do not lie
         * side by side [-]. */
        constexpr double least_cosine = 0.7;

        using Numbers = std::vector<unsigned int>;



        /** Fibers of one set that run along each other, and how far. */
        class Sheaf
        {
        public:
          Sheaf(const std::vector<Textile::FiberPath> &paths,
                const Numbers                         &fibers)
            : paths(paths)
            , fibers(fibers)
            , reach(lines())
          {
          }

          /** Whether there is an end where all others have one, and which way
           * fibers run can be told. */
          bool
          lies_side_by_side() const
          {
            return !reach.is_spun() &&
                   std::all_of(fibers.begin(), fibers.end(), [&](const auto f) {
                     const Tensor<1, 3> way = way_of(f);
                     return std::abs(way * reach.direction()) >
                            least_cosine * way.norm();
                   });
          }

          /** Those that run from end to end, but not as most of these do. */
          Numbers
          reversed() const
          {
            Numbers along, against;
            for (unsigned int i = 0; i < fibers.size(); ++i)
              {
                const auto &ends = reach.ends_with_yarn(i);
                if (ends[0] && ends[1])
                  (way_of(fibers[i]) * reach.direction() > 0. ? along : against)
                    .push_back(fibers[i]);
              }
            return along.size() < against.size() ? along : against;
          }

          /** Those of no yarn of which a chosen end lies amid the others: those
           * of yarns are told of anyway. */
          Numbers
          short_at(const ChosenNodes nodes) const
          {
            Numbers result;
            for (unsigned int i = 0; i < fibers.size(); ++i)
              {
                const auto &ends  = reach.ends_with_yarn(i);
                const bool  first = nodes != ChosenNodes::last_end && !ends[0],
                           last   = nodes != ChosenNodes::first_end && !ends[1];
                if ((first || last) &&
                    paths[fibers[i]].yarn_id == Textile::no_id)
                  result.push_back(fibers[i]);
              }
            return result;
          }

        private:
          std::vector<Polyline>
          lines() const
          {
            std::vector<Polyline> result;
            for (const unsigned int f : fibers)
              result.push_back(paths[f].points);
            return result;
          }

          Tensor<1, 3>
          way_of(const unsigned int fiber) const
          {
            const Polyline &points = paths[fiber].points;
            return points.back() - points.front();
          }

          const std::vector<Textile::FiberPath> &paths;
          const Numbers                          fibers;
          const YarnReach                        reach;
        };



        /** "fiber 3 and 2 others". */
        std::string
        in_words(const Numbers &fibers)
        {
          return "fiber " + std::to_string(fibers.front()) +
                 (fibers.size() == 1 ? ""
                  : fibers.size() == 2
                    ? " and another one"
                    : " and " + std::to_string(fibers.size() - 1) + " others");
        }



        /** What is to be said of the ends that section @p where chooses. */
        void
        add_notes(const Scene                        &scene,
                  const Contributions::NodeSelection &chosen,
                  const std::string                  &where,
                  std::vector<std::string>           &notes)
        {
          const bool is_one_end = chosen.nodes == ChosenNodes::first_end ||
                                  chosen.nodes == ChosenNodes::last_end;
          if (!is_one_end && chosen.nodes != ChosenNodes::both_ends)
            return;
          const std::string ends =
            is_one_end ? word(chosen.nodes) : std::string("end");
          const auto                    &paths = scene.fiber_paths();
          std::map<std::string, Numbers> sets;
          for (const unsigned int f : chosen.find_fibers(scene.space(), where))
            sets[paths[f].set].push_back(f);
          for (const auto &set : sets)
            {
              const Sheaf sheaf(paths, set.second);
              if (!sheaf.lies_side_by_side())
                continue;
              const Numbers reversed = sheaf.reversed();
              if (is_one_end && !reversed.empty())
                notes.push_back(
                  where + " takes the " + ends +
                  " of fibers that run opposite ways: that of " +
                  in_words(reversed) +
                  " (counted from 0) lies where the others have their other "
                  "end; let all points run one way in Centerlines/File, or "
                  "choose nodes near a point");
              const Numbers short_fibers = sheaf.short_at(chosen.nodes);
              if (!short_fibers.empty())
                notes.push_back(
                  where + " takes an end of " + in_words(short_fibers) +
                  " (counted from 0) that lies amid the fibers beside it, more "
                  "than a tenth of their length from their ends, and grips it "
                  "there; trace it to the end, or name other fibers in "
                  "'Fibers'");
            }
        }



        /** An end of a fiber, and where it looks. */
        struct End
        {
          unsigned int fiber;
          Tensor<1, 3> position, outwards;
        };



        std::vector<End>
        ends_of(const std::vector<Textile::FiberPath> &paths)
        {
          std::vector<End> ends;
          for (unsigned int f = 0; f < paths.size(); ++f)
            {
              const Polyline    &x = paths[f].points;
              const unsigned int n = x.size();
              ends.push_back({f, x[0], (x[0] - x[1]) / (x[0] - x[1]).norm()});
              ends.push_back(
                {f,
                 x[n - 1],
                 (x[n - 1] - x[n - 2]) / (x[n - 1] - x[n - 2]).norm()});
            }
          return ends;
        }



        /** Whether one looks at the other from so near that the note on
         * overlaps tells of them. */
        bool
        meet(const End                             &a,
             const End                             &b,
             const std::vector<Textile::FiberPath> &paths)
        {
          constexpr double much = 0.5, least_facing = 0.5, together = 0.1;
          const double     radius_a   = paths[a.fiber].radius,
                       radius_b       = paths[b.fiber].radius,
                       least          = std::min(radius_a, radius_b);
          const Tensor<1, 3> way      = b.position - a.position;
          const double       distance = way.norm();
          return distance < radius_a + radius_b - much * least &&
                 a.outwards * b.outwards < 0. &&
                 (distance < together * least ||
                  (a.outwards * way > least_facing * distance &&
                   -(b.outwards * way) > least_facing * distance));
        }
      } // namespace ChosenEnds
    }   // namespace internal



    std::vector<std::string>
    notes_on_chosen_ends(const Scene &scene, const Parameters &parameters)
    {
      using internal::ChosenEnds::add_notes;
      std::vector<std::string> notes;
      if (scene.weave())
        return notes;
      for (const auto &support : parameters.supports)
        add_notes(scene, support->nodes, support->where, notes);
      for (const auto &load : parameters.loads)
        add_notes(
          scene, load->nodes, Contributions::section_in_words(*load), notes);
      return notes;
    }



    std::string
    ends_that_meet(const Scene &scene)
    {
      using namespace internal::ChosenEnds;
      const auto &paths = scene.fiber_paths();
      auto        ends  = ends_of(paths);
      std::sort(ends.begin(), ends.end(), [](const End &a, const End &b) {
        return a.position[0] < b.position[0];
      });
      double widest = 0.;
      for (const Textile::FiberPath &path : paths)
        widest = std::max(widest, 2. * path.radius);
      for (unsigned int i = 0; i < ends.size(); ++i)
        for (unsigned int j = i + 1;
             j < ends.size() &&
             ends[j].position[0] - ends[i].position[0] < widest;
             ++j)
          if (meet(ends[i], ends[j], paths))
            {
              const End &a = ends[i].fiber < ends[j].fiber ? ends[i] : ends[j],
                        &b = ends[i].fiber < ends[j].fiber ? ends[j] : ends[i];
              std::ostringstream text;
              text << std::setprecision(3)
                   << (a.fiber == b.fiber
                         ? "both ends of fiber " + std::to_string(a.fiber)
                         : "ends of fibers " + std::to_string(a.fiber) +
                             " and " + std::to_string(b.fiber))
                   << " meet near (" << a.position[0] << ", " << a.position[1]
                   << ", " << a.position[2]
                   << ") and push each other apart: ends are halves of "
                      "spheres, and joined to nothing"
                   << (a.fiber == b.fiber
                         ? "; a closed loop is no fiber"
                         : "; let them be one fiber, or leave a gap between "
                           "their last points of both radii");
              return text.str();
            }
      return "";
    }
  } // namespace Simulation
} // namespace Heddle
