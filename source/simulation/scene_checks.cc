// Whether a scene is what it is meant to be: crossings, overlaps, and where its
// model ends.
#include <heddle/base/exceptions.h>
#include <heddle/post/bend.h>
#include <heddle/simulation/fabric_report.h>
#include <heddle/simulation/held_overlap.h>
#include <heddle/simulation/matrix.h>
#include <heddle/simulation/scene.h>
#include <heddle/textile/lost_fibers.h>
#include <heddle/textile/spun_yarns.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace Heddle
{
  namespace Simulation
  {
    void
    Scene::check_start() const
    {
      const auto weave = parameters.weave.description();
      if (!woven || weave.start != Textile::Start::crimped ||
          weave.crimp_factor > 0.)
        return;

      // The yarns are laid out so that all fibers are on their side: elements
      // that are too long for them follow them only so far.
      const std::string wrong = wrong_crossings();
      require(wrong.empty(),
              "Fiber/Elements per fiber: at the start " + wrong + ", since " +
                std::to_string(parameters.fiber.elements_per_fiber) +
                " elements are too few for the bends of a fiber; give more.");
    }



    Post::CrossingCount
    Scene::count_crossings() const
    {
      if (!woven)
        return {};
      // One rank knows all fibers, and all have to know what it says.
      return Utilities::MPI::broadcast(
        fiber_space->communicator(),
        FabricReport(*configuration).crossings(*woven));
    }



    std::string
    Scene::wrong_crossings() const
    {
      const Post::CrossingCount crossings = count_crossings();
      if (crossings.wrong == 0)
        return "";
      return std::to_string(crossings.wrong) + " of " +
             std::to_string(crossings.total) +
             " crossings of fibers are not as the pattern wants them";
    }



    std::string
    Scene::lost_crossings() const
    {
      const Post::CrossingCount crossings = count_crossings();
      if (crossings.apart == 0)
        return "";
      return std::to_string(crossings.apart) + " of " +
             std::to_string(crossings.total) +
             " pairs of fibers do not cross though the pattern wants it";
    }



    std::string
    Scene::turned_matrix() const
    {
      // Turned by an angle, material seems strained by half of its square.
      constexpr double large = 0.15, much = 0.05;
      if (!composite)
        return "";
      const auto turns = composite->elasticity()->turns(*configuration, large);
      if (turns.part < much)
        return "";
      std::ostringstream text;
      text << std::setprecision(2) << "Matrix/Law is linear, which takes turns "
           << "for strains: " << std::lround(100. * turns.part)
           << " % of the matrix has turned by more than " << large
           << " rad, up to " << turns.largest << "; another law is right there";
      return text.str();
    }



    std::unique_ptr<Contributions::FiberContact>
    Scene::contact_at_start(System::State &start) const
    {
      start.set(initial_blocks);
      start.accept();
      auto contact = std::make_unique<Contributions::FiberContact>(
        *fiber_space, parameters.contact);
      contact->update(start);
      return contact;
    }



    std::string
    Scene::deepest_overlap(const double allowed) const
    {
      if (woven || !fiber_contact)
        return "";
      System::State start(*fiber_space);
      const auto    contact = contact_at_start(start);
      contact->set_threshold(allowed);
      return contact->objection(start);
    }



    std::vector<std::string>
    Scene::overlaps_at_start() const
    {
      if (woven || !fiber_contact || !crumbled_fiber().empty())
        return {};
      constexpr double         much = 0.5;
      System::State            start(*fiber_space);
      const auto               contact = contact_at_start(start);
      std::vector<std::string> notes;
      if (supports && !is_fabric() && !contact->objection(start).empty())
        notes.push_back(held_overlap(
          *fiber_space, *contact, *supports, parameters.contact.threshold));
      contact->set_threshold(much);
      const std::string deepest = contact->objection(start);
      if (!deepest.empty())
        notes.push_back("at the start there is a " + deepest +
                        ", which contact has to undo; move fibers apart if it "
                        "finds no equilibrium");
      notes.erase(std::remove(notes.begin(), notes.end(), ""), notes.end());
      return notes;
    }



    std::string
    Scene::missing_torsion() const
    {
      constexpr double straight = 1e-6;
      if (parameters.fiber.element_kind != Beam::ElementKind::hermite ||
          woven || parameters.centerlines.straight_when_free)
        return "";
      System::State start(*fiber_space);
      start.set(initial_blocks);
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



    std::string
    Scene::crumbled_fiber() const
    {
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
           << least << " of its radius apart: memory and time of contact grow "
           << "with the square of how many lie within a radius; give longer "
              "elements"
           << (woven ? "" : ", and see whether Centerlines/Scale is right");
      return text.str();
    }



    std::string
    Scene::missed_points() const
    {
      constexpr double much  = 1.;
      const auto       worst = std::max_element(
        paths.begin(), paths.end(), [](const auto &left, const auto &right) {
          return left.missed / left.radius < right.missed / right.radius;
        });
      const double miss = worst->missed / worst->radius;
      if (miss < much)
        return "";
      std::ostringstream text;
      text << std::setprecision(2) << "elements are too long for the fibers of "
           << parameters.centerlines.file << ": points of fiber "
           << worst - paths.begin() << " are up to " << miss
           << " of its radii beside it; make Centerlines/Element length less";
      return text.str();
    }



    std::string
    Scene::turned_back() const
    {
      const auto worst = std::max_element(
        paths.begin(), paths.end(), [](const auto &left, const auto &right) {
          return left.n_turns < right.n_turns;
        });
      if (worst->n_turns == 0)
        return "";
      const unsigned int n =
        std::count_if(paths.begin(), paths.end(), [](const auto &path) {
          return path.n_turns > 0;
        });
      return parameters.centerlines.file + ": fiber " +
             std::to_string(worst - paths.begin()) + " (counted from 0)" +
             (n == 1 ? "" : ", like " + std::to_string(n - 1) + " others,") +
             " turns by more than 90 degrees at " +
             std::to_string(worst->n_turns) +
             (worst->n_turns == 1 ? " point" : " points") +
             "; see whether points are in their order, and not closer to each "
             "other than they are exact";
    }



    std::vector<std::string>
    Scene::notes() const
    {
      std::vector<std::string> result;
      if (woven)
        result = woven->notes();
      for (const std::string &note :
           {woven ? std::string()
                  : Textile::lost_fibers(paths, parameters.centerlines.file),
            woven ? std::string()
                  : Textile::spun_yarns(paths, parameters.centerlines.file),
            parameters.fabric_loading.strain_in_percent(),
            turned_back(),
            crumbled_fiber(),
            missed_points()})
        if (!note.empty())
          result.push_back(note);
      return result;
    }
  } // namespace Simulation
} // namespace Heddle
