// Whether a scene is what it is meant to be: crossings, overlaps, and where its
// model ends.
#include <heddle/base/exceptions.h>
#include <heddle/post/bend.h>
#include <heddle/simulation/fabric_report.h>
#include <heddle/simulation/matrix.h>
#include <heddle/simulation/scene.h>

#include <deal.II/base/mpi.h>

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



    std::string
    Scene::deepest_overlap(const double allowed) const
    {
      if (woven || !fiber_contact)
        return "";
      System::State start(*fiber_space);
      start.set(initial_blocks);
      start.accept();
      Contributions::FiberContact contact(*fiber_space, parameters.contact);
      contact.set_threshold(allowed);
      contact.update(start);
      return contact.objection(start);
    }



    std::string
    Scene::overlap_at_start() const
    {
      constexpr double  much    = 0.5;
      const std::string deepest = deepest_overlap(much);
      return deepest.empty() ? ""
                             : "at the start there is a " + deepest +
                                 ", which contact has to undo; move fibers "
                                 "apart if it finds no equilibrium";
    }



    std::string
    Scene::missing_torsion() const
    {
      constexpr double straight = 1e-6;
      if (parameters.fiber.element_name != "hermite" || woven ||
          parameters.centerlines.straight_when_free)
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



    std::vector<std::string>
    Scene::notes() const
    {
      std::vector<std::string> result;
      if (woven)
        result = woven->notes();
      if (measured && !measured->short_fibers().empty())
        result.push_back(measured->short_fibers());
      return result;
    }
  } // namespace Simulation
} // namespace Heddle
