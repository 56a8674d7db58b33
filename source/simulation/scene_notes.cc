#include <heddle/base/yarn_set.h>
#include <heddle/post/bend.h>
#include <heddle/simulation/chosen_ends.h>
#include <heddle/simulation/held_overlap.h>
#include <heddle/simulation/scene_notes.h>
#include <heddle/simulation/stray_fibers.h>
#include <heddle/textile/gaps_in_bends.h>
#include <heddle/textile/lost_fibers.h>
#include <heddle/textile/spun_yarns.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <optional>
#include <sstream>

namespace Heddle
{
  namespace Simulation
  {
    namespace
    {
      /** Whose elements are so short that contact takes all memory, or nothing.
       */
      std::string
      crumbled_fiber(const Scene &scene)
      {
        const auto      &paths    = scene.fiber_paths();
        constexpr double shortest = 0.05;
        double           least    = shortest;
        unsigned int     worst    = 0;
        for (unsigned int f = 0; f < paths.size(); ++f)
          {
            const Textile::FiberPath &path = paths[f];
            const double              part =
              path.reference_length / (path.points.size() - 1) / path.radius;
            if (part < least)
              {
                least = part;
                worst = f;
              }
          }
        if (least == shortest)
          return "";
        std::ostringstream text;
        text << std::setprecision(2) << "nodes of fiber " << worst << " are "
             << least
             << " of its radius apart: memory and time of contact grow "
             << "with the square of how many lie within a radius; give longer "
                "elements"
             << (scene.weave()
                   ? ""
                   : ", and see whether Centerlines/Scale is right");
        return text.str();
      }



      /** Whose elements are too long for the points of @p file, or nothing. */
      std::string
      missed_points(const Scene &scene, const std::string &file)
      {
        const auto      &paths = scene.fiber_paths();
        constexpr double much  = 1.;
        const auto       worst = std::max_element(
          paths.begin(), paths.end(), [](const auto &left, const auto &right) {
            return left.missed / left.radius < right.missed / right.radius;
          });
        const double miss = worst->missed / worst->radius;
        if (miss < much)
          return "";
        std::ostringstream text;
        text << std::setprecision(2)
             << "elements are too long for the fibers of " << file
             << ": points of fiber " << worst - paths.begin() << " are up to "
             << miss
             << " of its radii beside it; make Centerlines/Element length less";
        return text.str();
      }



      /** Which fibers of @p file turn back at some of their points, which may
       * not be in order; nothing if there are none. */
      std::string
      turned_back(const Scene &scene, const std::string &file)
      {
        const auto &paths = scene.fiber_paths();
        const auto  worst = std::max_element(
          paths.begin(), paths.end(), [](const auto &left, const auto &right) {
            return left.n_turns < right.n_turns;
          });
        if (worst->n_turns == 0)
          return "";
        const unsigned int n =
          std::count_if(paths.begin(), paths.end(), [](const auto &path) {
            return path.n_turns > 0;
          });
        return file + ": fiber " + std::to_string(worst - paths.begin()) +
               " (counted from 0)" +
               (n == 1 ? "" : ", like " + std::to_string(n - 1) + " others,") +
               " turns by more than 90 degrees at " +
               std::to_string(worst->n_turns) +
               (worst->n_turns == 1 ? " point" : " points") +
               "; see whether points are in their order, and not closer to "
               "each other than they are exact";
      }



      /** Where the yarns of a measured fabric run to, if that is not along the
       * axes that a test acts along, or nothing. */
      std::string
      askew_fabric(const Scene &scene, const Parameters &parameters)
      {
        if (scene.weave() || !scene.is_fabric() ||
            !parameters.fabric_loading.is_active())
          return "";
        // In a picture frame a plain weave resisted 1.4 % more at 1 degree,
        // 13 % more at 3.
        constexpr double much = 1.;
        Tensor<1, 3>     warp, weft;
        for (const Textile::FiberPath &path : scene.fiber_paths())
          (path.set == word(YarnSet::warp) ? warp : weft) +=
            path.points.back() - path.points.front();
        const double degree  = numbers::PI / 180.;
        const double of_warp = std::atan2(warp[1], warp[0]) / degree,
                     of_weft = std::atan2(weft[1], weft[0]) / degree;
        if (std::max(std::abs(of_warp), std::abs(of_weft - 90.)) < much)
          return "";
        std::ostringstream text;
        text << std::fixed << std::setprecision(1)
             << parameters.centerlines.file << ": the warp runs at " << of_warp
             << " degrees to the x-axis and the weft at " << of_weft
             << ", and tests act along 0 and 90: turn the fabric by "
             << 0.5 * (90. - of_warp - of_weft) << " degrees about z";
        return text.str();
      }



      /** By how much a measured fabric lies out of the xy-plane, if it does, or
       * nothing. */
      std::string
      tilted_fabric(const Scene &scene, const Parameters &parameters)
      {
        const auto &paths = scene.fiber_paths();
        const auto  has   = [&paths](const YarnSet set) {
          return std::any_of(
            paths.begin(), paths.end(), [set](const Textile::FiberPath &path) {
              return path.set == word(set);
            });
        };
        if (scene.weave() || !has(YarnSet::warp) || !has(YarnSet::weft))
          return "";

        // Crimp tilts the mean plane of few yarns, of a basket of 3 + 3 yarns
        // by 1.9 degrees. A fabric that lay askew by 5 was thicker by a
        // quarter.
        constexpr double much = 2.5;

        // The plane z = a x + b y that is next to all points about their mean.
        Tensor<1, 3> mean;
        double       n = 0.;
        for (const Textile::FiberPath &path : paths)
          for (const Tensor<1, 3> &point : path.points)
            {
              mean += point;
              n += 1.;
            }
        mean /= n;
        Tensor<2, 2> spread;
        Tensor<1, 2> rise;
        for (const Textile::FiberPath &path : paths)
          for (const Tensor<1, 3> &point : path.points)
            {
              const Tensor<1, 3> place = point - mean;
              for (unsigned int i = 0; i < 2; ++i)
                {
                  rise[i] += place[i] * place[2];
                  for (unsigned int j = 0; j < 2; ++j)
                    spread[i][j] += place[i] * place[j];
                }
            }
        if (!(determinant(spread) > 0.))
          return "";
        const Tensor<1, 2> slope  = invert(spread) * rise;
        const double       degree = numbers::PI / 180.;
        if (std::atan(slope.norm()) < much * degree)
          return "";
        std::ostringstream text;
        text << std::fixed << std::setprecision(1)
             << parameters.centerlines.file << ": the fabric rises by "
             << std::atan(slope[0]) / degree << " degrees along x and "
             << std::atan(slope[1]) / degree
             << " along y, and is measured, pressed and pulled as if it lay in "
                "the xy-plane: turn it into that";
        return text.str();
      }



      /** By how much a curve turns from end to end, all ways [degrees]. */
      double
      turned_by(const Polyline &points)
      {
        double angle = 0.;
        for (unsigned int i = 2; i < points.size(); ++i)
          {
            const Tensor<1, 3> before = points[i - 1] - points[i - 2],
                               after  = points[i] - points[i - 1];
            angle += std::atan2(cross_product_3d(before, after).norm(),
                                before * after);
          }
        return angle * 180. / numbers::PI;
      }



      /** The first fiber on which a load with a moment about its axis acts, or
       * none. */
      std::optional<unsigned int>
      twisted_fiber(const Scene                         &scene,
                    const Contributions::LoadParameters &load)
      {
        constexpr double much = 0.1;
        if (load.has_moment())
          for (const unsigned int f : load.nodes.find_fibers(
                 scene.space(), Contributions::section_in_words(load)))
            {
              const auto        &points = scene.fiber_paths()[f].points;
              const Tensor<1, 3> chord  = points.back() - points.front();
              for (unsigned int d = 0; d < 3; ++d)
                if (load.moment[d] != "0" &&
                    std::abs(chord[d]) > much * chord.norm())
                  return f;
            }
        return {};
      }



      /** A moment about an axis that nothing resists, or nothing. */
      std::string
      moment_that_spins(const Scene &scene, const Parameters &parameters)
      {
        if (parameters.fiber.element_kind == Beam::ElementKind::hermite ||
            (parameters.matrix.enabled &&
             parameters.matrix.section_links != SectionLinks::never) ||
            scene.friction() != nullptr ||
            std::any_of(parameters.supports.begin(),
                        parameters.supports.end(),
                        [](const auto &support) {
                          return support->section !=
                                 Contributions::SupportedSection::free;
                        }))
          return "";
        for (unsigned int i = 0; i < parameters.loads.size(); ++i)
          if (const auto fiber = twisted_fiber(scene, *parameters.loads[i]))
            return "Loads/Load " + std::to_string(i + 1) +
                   " has a moment about the axis of fiber " +
                   std::to_string(*fiber) +
                   ", and no support holds a section: one that is straight "
                   "when free spins, and there is no equilibrium; set "
                   "Supports/Support 1/Section = held" +
                   (parameters.matrix.enabled
                      ? ", or Matrix/Link sections = automatic"
                      : "");
        return "";
      }



      /** Fibers that keep no plane of their bends, which nothing else holds
       * either, or nothing. */
      std::string
      limp_fibers(const Scene &scene, const Parameters &parameters)
      {
        if (parameters.fiber.element_kind != Beam::ElementKind::hermite ||
            scene.weave() || parameters.centerlines.straight_when_free ||
            parameters.matrix.enabled || scene.stages().empty())
          return "";
        constexpr double    much  = 10.;
        const auto         &paths = scene.fiber_paths();
        std::vector<double> angles;
        for (const Textile::FiberPath &path : paths)
          angles.push_back(turned_by(path.points));
        const auto most = std::max_element(angles.begin(), angles.end());
        if (*most < much)
          return "";
        return "fibers are curved when free, fiber " +
               std::to_string(most - angles.begin()) + " by " +
               std::to_string(std::lround(*most)) +
               " degrees, and without torsion, as Fiber/Element = hermite has "
               "them, they bend into another plane for nothing: forces may be "
               "far too small; 'director' has torsion, and with "
               "Centerlines/Straight when free they resist all bends";
      }



      /** Contact of the fibers that were given, where they start. */
      std::unique_ptr<Contributions::FiberContact>
      contact_at_start(const Scene      &scene,
                       const Parameters &parameters,
                       System::State    &start)
      {
        start.set(scene.initial());
        start.accept();
        auto contact = std::make_unique<Contributions::FiberContact>(
          scene.space(), parameters.contact);
        contact->update(start);
        return contact;
      }
    } // namespace



    std::vector<std::string>
    notes_on_fibers(const Scene &scene, const Parameters &parameters)
    {
      const std::string       &file = parameters.centerlines.file;
      std::vector<std::string> notes;
      if (scene.weave())
        notes = scene.weave()->notes();
      else
        {
          notes.push_back(Textile::lost_fibers(scene.fiber_paths(), file));
          notes.push_back(Textile::spun_yarns(scene.fiber_paths(), file));
          notes.push_back(Textile::gaps_in_bends(scene.fiber_paths(), file));
          if (scene.is_fabric())
            notes.push_back(stray_fibers(scene.fiber_paths(), file));
        }
      for (const std::string &note :
           {parameters.fabric_loading.strain_in_percent(),
            turned_back(scene, file),
            askew_fabric(scene, parameters),
            tilted_fabric(scene, parameters),
            crumbled_fiber(scene),
            missed_points(scene, file),
            limp_fibers(scene, parameters),
            moment_that_spins(scene, parameters)})
        notes.push_back(note);
      for (const std::string &note : notes_on_chosen_ends(scene, parameters))
        notes.push_back(note);
      notes.erase(std::remove(notes.begin(), notes.end(), ""), notes.end());
      return notes;
    }



    std::vector<std::string>
    overlaps_at_start(const Scene &scene, const Parameters &parameters)
    {
      if (scene.weave() || !scene.contact() || !crumbled_fiber(scene).empty())
        return {};
      constexpr double much = 0.5;
      System::State    start(scene.space());
      const auto       contact = contact_at_start(scene, parameters, start);
      std::vector<std::string> notes;
      if (scene.supports() && !scene.is_fabric() &&
          !contact->objection(start).empty())
        notes.push_back(held_overlap(scene.space(),
                                     *contact,
                                     *scene.supports(),
                                     parameters.contact.threshold));
      contact->set_threshold(much);
      const std::string deepest = contact->objection(start);
      if (!deepest.empty())
        notes.push_back("at the start there is a " + deepest +
                        ", which contact has to undo; move fibers apart if it "
                        "finds no equilibrium");
      notes.push_back(ends_that_meet(scene));
      notes.erase(std::remove(notes.begin(), notes.end(), ""), notes.end());
      return notes;
    }



    std::string
    deepest_overlap(const Scene      &scene,
                    const Parameters &parameters,
                    const double      allowed)
    {
      if (scene.weave() || !scene.contact())
        return "";
      System::State start(scene.space());
      const auto    contact = contact_at_start(scene, parameters, start);
      contact->set_threshold(allowed);
      return contact->objection(start);
    }



    std::string
    missing_torsion(const Scene &scene, const Parameters &parameters)
    {
      constexpr double straight = 1e-6;
      if (parameters.fiber.element_kind != Beam::ElementKind::hermite ||
          scene.weave() || parameters.centerlines.straight_when_free)
        return "";
      System::State start(scene.space());
      start.set(scene.initial());
      return Post::sharpest_bend(start).ratio < straight
               ? ""
               : "fibers are curved when free, and without torsion, as Fiber/"
                 "Element = hermite has them, they bend into another plane for "
                 "nothing: 'director' has torsion" +
                   std::string(parameters.matrix.enabled &&
                                   parameters.matrix.points_per_element == 0
                                 ? ", and Matrix/Coupling points per element = "
                                   "2 holds their tangents"
                                 : "");
    }
  } // namespace Simulation
} // namespace Heddle
