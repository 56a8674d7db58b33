#include <heddle/base/exceptions.h>
#include <heddle/base/file.h>
#include <heddle/base/number_text.h>
#include <heddle/base/throw_together.h>
#include <heddle/textile/csv_table.h>
#include <heddle/textile/parametric_curve.h>
#include <heddle/textile/path_reader.h>
#include <heddle/textile/point_order.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      /** Points so near each other, by how far they are from the origin, differ
       * in no digit but the last ones. */
      constexpr double same = 1e-12;

      /** The points of one fiber, scaled, and where the file speaks of it. */
      struct RawFiber
      {
        std::string               name;
        std::vector<Tensor<1, 3>> points;
        double                    sum_of_radii = 0.;
        std::string               set;
        std::string               yarn;
        unsigned int              first_line = 0;
      };



      void
      check(const PathReading &reading)
      {
        const auto refuse = [](const std::string &what, const double value) {
          throw InputError("Fibers from a file: the " + what + " is " +
                           number_text(value) + " mm; it must be positive.");
        };
        // A number compares false with everything if it is not one.
        if (!(reading.element_length > 0.))
          refuse("element length", reading.element_length);
        if (!(reading.scale > 0.))
          refuse("scale", reading.scale);
        if (!(reading.radius >= 0.))
          refuse("fiber radius", reading.radius);
      }



      double
      radius_of_line(const CsvTable &table, const PathReading &reading)
      {
        if (reading.radius > 0.)
          return reading.radius;
        const double radius = table.number("radius");
        if (radius <= 0.)
          table.fail("the radius is " + table.text("radius") +
                     "; it must be positive.");
        return reading.scale * radius;
      }



      /** What column @p name says of the whole fiber; nothing without it. */
      std::string
      word_of_fiber(const CsvTable &table, const std::string &name)
      {
        const std::string word = table.has(name) ? table.text(name) : "";
        if (word.find_first_of(",\"") != std::string::npos)
          table.fail("the " + name + " '" + word +
                     "' has a comma or a quotation mark in it, which lists of "
                     "names and tables have between them; leave it out.");
        return word;
      }



      std::string
      set_of_fiber(const CsvTable &table)
      {
        const std::string set = word_of_fiber(table, "set");
        if (set == "none")
          table.fail("the set is named 'none', by which parameters choose no "
                     "fibers; leave the entry empty, or give the set another "
                     "name.");
        return set;
      }



      /** Refuse that @p fiber is of another @p kind here than it was before. */
      void
      check_same(const CsvTable    &table,
                 const RawFiber    &fiber,
                 const std::string &kind,
                 const std::string &before)
      {
        const std::string here = word_of_fiber(table, kind);
        if (here != before)
          table.fail("fiber '" + fiber.name + "' belongs to " + kind + " '" +
                     here + "' here but to '" + before +
                     "' before; give all its points the same " + kind + ".");
      }



      /** Add the point of the current line to its fiber. */
      void
      add_point(const CsvTable    &table,
                const PathReading &reading,
                RawFiber          &fiber)
      {
        const Tensor<1, 3> point =
          reading.scale *
          Tensor<1, 3>(
            {table.number("x"), table.number("y"), table.number("z")});

        if (fiber.points.empty())
          {
            fiber.name       = table.text("fiber");
            fiber.set        = set_of_fiber(table);
            fiber.yarn       = word_of_fiber(table, "yarn");
            fiber.first_line = table.line();
          }
        check_same(table, fiber, "set", fiber.set);
        check_same(table, fiber, "yarn", fiber.yarn);
        if (!fiber.points.empty() &&
            (point - fiber.points.back()).norm() <= same * point.norm())
          table.fail("fiber '" + fiber.name +
                     "' has the same point twice in a row; remove one.");

        fiber.points.push_back(point);
        fiber.sum_of_radii += radius_of_line(table, reading);
      }



      std::vector<RawFiber>
      read_points(std::istream      &input,
                  const std::string &name,
                  const PathReading &reading)
      {
        CsvTable table(
          input, name, {"fiber", "x", "y", "z"}, {"radius", "set", "yarn"});
        if (reading.radius == 0. && !table.has("radius"))
          table.fail("there is no column 'radius' and no radius was given; add "
                     "the column, or set the radius of all fibers.");

        std::vector<RawFiber>               fibers;
        std::map<std::string, unsigned int> numbers;
        while (table.next())
          {
            const std::string word = table.text("fiber");
            if (word.empty())
              table.fail("the name of the fiber is missing; give a word or a "
                         "number in column 'fiber'.");
            const auto place = numbers.emplace(word, fibers.size());
            if (place.second)
              fibers.emplace_back();
            add_point(table, reading, fibers[place.first->second]);
          }
        if (fibers.empty())
          throw InputError(name + ": there are no points below the header; "
                                  "give at least two for each fiber.");
        return fibers;
      }



      /**
       * Number the yarns in the order in which they appear, or as they are
       * called. A yarn runs in one direction: all its fibers are of one set.
       */
      void
      number_yarns(const std::vector<RawFiber> &fibers,
                   const std::string           &name,
                   std::vector<FiberPath>      &paths)
      {
        struct Yarn
        {
          unsigned int    number;
          const RawFiber *first;
        };
        std::map<std::string, Yarn> yarns;
        for (unsigned int f = 0; f < fibers.size(); ++f)
          {
            const RawFiber &fiber = fibers[f];
            if (fiber.yarn.empty())
              continue;
            const unsigned int next = yarns.size();
            const Yarn        &yarn =
              yarns.emplace(fiber.yarn, Yarn{next, &fiber}).first->second;
            if (yarn.first->set != fiber.set)
              throw InputError(name + ":" + std::to_string(fiber.first_line) +
                               ": fiber '" + fiber.name + "' belongs to set '" +
                               fiber.set + "', but '" + yarn.first->name +
                               "' of the same yarn '" + fiber.yarn + "' to '" +
                               yarn.first->set +
                               "'; give all fibers of a yarn the same set.");
            paths[f].yarn_id = yarn.number;
          }

        // A run names them so, in the order of its fibers.
        bool are_numbers = true;
        for (unsigned int y = 0; y < yarns.size(); ++y)
          are_numbers = are_numbers && yarns.count(std::to_string(y)) > 0;
        if (are_numbers)
          for (unsigned int f = 0; f < fibers.size(); ++f)
            if (!fibers[f].yarn.empty())
              paths[f].yarn_id = std::stoul(fibers[f].yarn);
      }



      /** What results of yarns of @p set and others would both be called, of
       * those that are named after @p sets; nothing if all names are apart. */
      std::string
      shared_result(const std::string                             &set,
                    const std::map<std::string, const RawFiber *> &sets)
      {
        if (set == "all")
          return "all";
        if (set == "fiber")
          return "fiber_volume_fraction";
        // The crimp of "a_inner" and the inner crimp of "a".
        for (const auto &other : sets)
          if (set == (other.first.empty() ? "" : other.first + "_") + "inner")
            return set + "_crimp";
        return "";
      }



      /** Results of yarns are named after their sets: refuse names by which one
       * would hide another. */
      void
      check_results(const std::vector<RawFiber> &fibers,
                    const std::string           &name)
      {
        std::map<std::string, const RawFiber *> sets;
        for (const RawFiber &fiber : fibers)
          if (!fiber.yarn.empty())
            sets.emplace(fiber.set, &fiber);
        for (const auto &[set, first] : sets)
          {
            const std::string shared = shared_result(set, sets);
            if (!shared.empty())
              throw InputError(name + ":" + std::to_string(first->first_line) +
                               ": yarns of the set '" + set +
                               "' have a result '" + shared +
                               "', and so have others; give the set another "
                               "name.");
          }
      }



      /** Distance of @p point from the straight line from @p a to @p b [mm]. */
      double
      distance_to_line(const Tensor<1, 3> &point,
                       const Tensor<1, 3> &a,
                       const Tensor<1, 3> &b)
      {
        const Tensor<1, 3> line = b - a;
        const double       t =
          std::clamp((point - a) * line / line.norm_square(), 0., 1.);
        return (point - a - t * line).norm();
      }



      /**
       * Largest distance of @p points from the curve through @p knots, which
       * passes them in their order [mm].
       */
      double
      largest_miss(const std::vector<Tensor<1, 3>> &points,
                   const Polyline                  &knots,
                   const Interpolation              interpolation)
      {
        constexpr unsigned int  n_parts = 8;
        const InterpolatedCurve curve(knots, interpolation);
        const unsigned int      n_lines = n_parts * (knots.size() - 1);
        Polyline                lines;
        for (unsigned int i = 0; i <= n_lines; ++i)
          lines.push_back(curve(curve.end() * i / n_lines));

        // The next point is nearest to what is not far beyond that of the last.
        const unsigned int far =
          std::max<std::size_t>(2 * n_parts, 4 * n_lines / points.size());
        double       largest = 0.;
        unsigned int nearest = 0;
        for (const Tensor<1, 3> &point : points)
          {
            double             least = std::numeric_limits<double>::max();
            const unsigned int begin = nearest;
            for (unsigned int i = begin; i < n_lines; ++i)
              {
                const double distance =
                  distance_to_line(point, lines[i], lines[i + 1]);
                if (distance < least)
                  {
                    least   = distance;
                    nearest = i;
                  }
                else if (i > nearest + far)
                  break;
              }
            largest = std::max(largest, least);
          }
        return largest;
      }



      /** The two of @p points that follow each other at the largest distance.
       */
      std::array<Tensor<1, 3>, 2>
      widest_gap(const std::vector<Tensor<1, 3>> &points)
      {
        const auto gap = [&points](const unsigned int i) {
          return (points[i + 1] - points[i]).norm_square();
        };
        unsigned int widest = 0;
        for (unsigned int i = 1; i + 1 < points.size(); ++i)
          if (gap(i) > gap(widest))
            widest = i;
        return {{points[widest], points[widest + 1]}};
      }



      FiberPath
      resample(const RawFiber    &fiber,
               const std::string &name,
               const PathReading &reading)
      {
        if (fiber.points.size() < 2)
          throw InputError(name + ":" + std::to_string(fiber.first_line) +
                           ": fiber '" + fiber.name +
                           "' has only one point; give at least two.");

        const PointOrder order = order_of(fiber.points);
        if (order.is_lost())
          throw InputError(
            name + ":" + std::to_string(fiber.first_line) + ": fiber '" +
            fiber.name + "' turns back at " + std::to_string(order.n_turns) +
            " of its " + std::to_string(fiber.points.size()) +
            " points and is " + number_text(order.excess, 2) +
            " times as long as the way from each to the nearest one; give "
            "them in their order along the fiber, and not closer to each "
            "other than they are exact, or, where it does turn so, more of "
            "them between its turns.");

        const unsigned int fold =
          folded_at(fiber.points, 0.5 * reading.element_length);
        if (fold > 0)
          throw InputError(name + ":" + std::to_string(fiber.first_line) +
                           ": fiber '" + fiber.name +
                           "' goes straight back on itself at point " +
                           std::to_string(fold + 1) + " of " +
                           std::to_string(fiber.points.size()) +
                           "; give its points in their order along the fiber "
                           "or, where it does turn so, more of them.");

        const InterpolatedCurve curve(fiber.points, reading.interpolation);
        const unsigned int      n_samples = 64 * (fiber.points.size() - 1);
        const double            length =
          equally_spaced(curve, 0., curve.end(), 2, n_samples).length;
        const double n_elements =
          std::max(1., std::round(length / reading.element_length));
        if (n_elements > 1e6)
          throw InputError(name + ":" + std::to_string(fiber.first_line) +
                           ": fiber '" + fiber.name + "' is " +
                           number_text(length, 4) +
                           " mm long and would get more than a million "
                           "elements; enlarge the element length.");

        const Knots knots =
          equally_spaced(curve,
                         0.,
                         curve.end(),
                         reading.knots_per_element * n_elements + 1,
                         n_samples);
        const Tensor<1, 3> chord = knots.points[1] - knots.points[0];
        if (chord.norm() <= same * length)
          throw InputError(name + ":" + std::to_string(fiber.first_line) +
                           ": fiber '" + fiber.name +
                           "' ends where it begins and would get one element, "
                           "of no length; make the element length less.");

        FiberPath path;
        path.points = knots.points;
        path.missed =
          largest_miss(fiber.points, knots.points, reading.interpolation);
        path.n_turns          = order.n_turns;
        path.gap              = widest_gap(fiber.points);
        path.reference_length = knots.length / (1. + reading.axial_strain);
        path.radius           = fiber.sum_of_radii / fiber.points.size();
        path.set              = fiber.set;
        return path;
      }
    } // namespace



    std::vector<FiberPath>
    read_paths(std::istream      &input,
               const std::string &name,
               const PathReading &reading)
    {
      check(reading);
      const std::vector<RawFiber> fibers = read_points(input, name, reading);
      std::vector<FiberPath>      paths;
      for (const RawFiber &fiber : fibers)
        paths.push_back(resample(fiber, name, reading));
      number_yarns(fibers, name, paths);
      check_results(fibers, name);
      return paths;
    }



    std::vector<FiberPath>
    read_paths(const std::string &file_name,
               const PathReading &reading,
               const MPI_Comm     communicator)
    {
      const auto read = [&]() {
        std::error_code unreachable;
        if (!std::filesystem::exists(file_name, unreachable))
          throw InputError(file_name + ": the file cannot be opened; check its "
                                       "name in the parameter file, from whose "
                                       "folder it counts.");
        std::istringstream input(read_file(file_name, "file of centerlines"));
        return read_paths(input, file_name, reading);
      };
      return ask_first_rank(read, communicator);
    }
  } // namespace Textile
} // namespace Heddle
