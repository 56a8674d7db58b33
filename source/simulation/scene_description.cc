#include <heddle/base/exceptions.h>
#include <heddle/simulation/notes_on_units.h>
#include <heddle/simulation/scene_description.h>
#include <heddle/simulation/scene_estimate.h>
#include <heddle/simulation/scene_notes.h>
#include <heddle/textile/linear_density.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <limits>
#include <sstream>

namespace Heddle
{
  namespace Simulation
  {
    namespace
    {
      /** "2.4 x 2.4 x 0.1 mm": what shows that a length is in another unit. */
      std::string
      extent_in_words(const Scene &scene)
      {
        const System::FiberSpace &space = scene.space();
        const double              none  = std::numeric_limits<double>::max();
        std::vector<double>       low(3, none), high(3, -none);
        for (std::size_t b = 0; b < scene.initial().size();
             b += space.n_blocks_per_node())
          for (unsigned int d = 0; d < 3; ++d)
            {
              low[d]  = std::min(low[d], scene.initial()[b][d]);
              high[d] = std::max(high[d], scene.initial()[b][d]);
            }
        Utilities::MPI::min(low, space.communicator(), low);
        Utilities::MPI::max(high, space.communicator(), high);
        std::ostringstream text;
        text << std::setprecision(3) << high[0] - low[0] << " x "
             << high[1] - low[1] << " x " << high[2] - low[2] << " mm";
        return text.str();
      }



      /** What yarns and fabric weigh, if the densities of fibers are known. */
      void
      print_weights(Log                             &log,
                    const Textile::Weave            &weave,
                    const Textile::WeaveDescription &description)
      {
        const bool warp = description.warp.density > 0.,
                   weft = description.weft.density > 0.;
        if (warp)
          log << "Warp           "
              << Textile::yarns_in_words(description.warp, weave.warp_spacing())
              << '\n';
        if (weft)
          log << "Weft           "
              << Textile::yarns_in_words(description.weft, weave.weft_spacing())
              << '\n';
        // Grams per kilometer over millimeters are grams per square meter.
        if (warp && weft)
          log << "Areal weight   " << std::setprecision(3)
              << Textile::linear_density(description.warp) /
                     weave.warp_spacing() +
                   Textile::linear_density(description.weft) /
                     weave.weft_spacing()
              << " g/m^2, without crimp\n";
      }



      /** "94.3" or, where fibers differ, "94.3 to 120" [MPa], at the strain of
       * each set of fibers. */
      std::string
      tension_in_words(const System::FiberSpace                         &space,
                       const std::function<double(const std::string &)> &strain)
      {
        double low = std::numeric_limits<double>::max(), high = 0.;
        for (unsigned int f = 0; f < space.n_fibers(); ++f)
          {
            const double radius = space.fiber(f).radius;
            const double stress = strain(space.fiber(f).set) *
                                  space.fiber(f).section.axial /
                                  (numbers::PI * radius * radius);
            low  = std::min(low, stress);
            high = std::max(high, stress);
          }
        std::ostringstream text;
        text << std::setprecision(3) << low;
        if (high > 1.001 * low)
          text << " to " << high;
        return text.str();
      }



      /** How many fibers are of each material, a line if there are several. */
      std::string
      materials_in_words(const System::FiberSpace &space,
                         const FiberParameters    &parameters)
      {
        if (parameters.materials.empty())
          return "";
        const auto  numbers = parameters.materials_of(space.names());
        std::string text;
        for (unsigned int i = 0; i <= parameters.materials.size(); ++i)
          text +=
            (i == 0 ? "Materials      " : ", ") +
            std::to_string(std::count(numbers.begin(), numbers.end(), i)) +
            (i == 0 ? " fibers of section Fiber"
                    : " of Material " + std::to_string(i));
        return text + '\n';
      }



      void
      print_fibers(Log              &log,
                   const Scene      &scene,
                   const Parameters &parameters,
                   const bool        settles)
      {
        const System::FiberSpace &space = scene.space();
        log << "Fibers         " << space.n_fibers();
        if (space.n_yarns() > 0)
          log << " in " << space.n_yarns() << " yarns";
        log << '\n' << materials_in_words(space, parameters.fiber);
        if (scene.weave())
          print_weights(log, *scene.weave(), parameters.weave.description());
        if (settles)
          log << "Tension        "
              << tension_in_words(space,
                                  [&parameters](const std::string &set) {
                                    return parameters.settle.tension_of(set);
                                  })
              << " MPa in every fiber while the fabric settles, with which a "
                 "test begins (Initial configuration/Axial tension)\n";
        // The stress at a strain of 1e-3, in MPa, is the modulus in GPa, as
        // data sheets have it.
        log << "Stiffness      "
            << tension_in_words(space, [](const std::string &) { return 1e-3; })
            << " GPa along the fibers (Fiber/Axial modulus, or Axial "
               "stiffness over the area)\n"
            << "Extent         " << extent_in_words(scene) << " at the start\n"
            << "Nodes          " << space.n_nodes() << '\n'
            << "Unknowns       " << space.n_dofs() << '\n';
      }



      void
      print_matrix(Log                  &log,
                   const MatrixEstimate &matrix,
                   const double          youngs_modulus)
      {
        if (!matrix.objection.empty())
          log << "Note           the matrix is not known where fibers start: "
              << matrix.objection << '\n';
        else
          log << "Matrix         about " << std::lround(matrix.n_cells)
              << " cells, " << std::lround(matrix.n_nodes) << " nodes, "
              << std::lround(3. * matrix.n_nodes)
              << " unknowns, around the fibers where they start\n"
              << "               " << std::setprecision(3) << matrix.extent[0]
              << " x " << matrix.extent[1] << " x " << matrix.extent[2]
              << " mm, of " << youngs_modulus / 1000.
              << " GPa (Matrix/Youngs modulus)\n";
      }



      /** Sheared by more, a linear matrix is off by some percent [degrees]. */
      constexpr double large_angle = 10.;

      /** Above this Poisson ratio corners of cells of degree 2 bear 5 % and
       * more of what a matrix does, and without limit towards 0.5 [-]. */
      constexpr double rigid_volume = 0.49;



      void
      print_contributions(Log              &log,
                          const Scene      &scene,
                          const Parameters &parameters)
      {
        std::string comma;
        for (const std::string &name : scene.contribution_names())
          {
            log << comma << name;
            comma = ", ";
          }
        for (const std::string &overlap : overlaps_at_start(scene, parameters))
          log << "\nNote           " << overlap;
        if (parameters.matrix.enabled &&
            parameters.matrix.material.law == Solid::MaterialLaw::linear &&
            (parameters.fabric_loading.largest_shear_angle() > large_angle ||
             parameters.fabric_loading.bends()))
          log << "\nNote           Matrix/Law is linear, which takes turns for "
                 "strains: under such loads set Matrix/Law = neo-hookean";
        if (parameters.matrix.enabled && parameters.matrix.degree > 1 &&
            parameters.matrix.material.poisson_ratio > rigid_volume &&
            parameters.fabric_loading.is_active() &&
            !parameters.fabric_loading.leaves_yarns_free())
          log << "\nNote           Matrix/Degree is "
              << parameters.matrix.degree
              << ", and the matrix hardly changes its volume: where two held "
                 "sides meet pressures grow with its bulk modulus, and forces "
                 "of the sides count them; take degree 1";
      }



      /** "0.012 s", "25 s" or "7 min". */
      std::string
      in_words(const double seconds)
      {
        std::ostringstream text;
        if (seconds < 10.)
          text << std::setprecision(2) << seconds << " s";
        else if (seconds < 100.)
          text << std::lround(seconds) << " s";
        else
          text << std::lround(seconds / 60.) << " min";
        return text.str();
      }



      /** "12 s to 77 s". */
      std::string
      in_words(const SceneEstimate::Range &seconds)
      {
        return in_words(seconds.first) + " to " + in_words(seconds.second);
      }



      /** @p iterations of @p seconds each, in all of so many @p times. */
      void
      print_iterations(Log                        &log,
                       const SceneEstimate::Range &iterations,
                       const SceneEstimate::Range &times,
                       const double                seconds)
      {
        log << std::defaultfloat << std::setprecision(6) << iterations.first
            << " to " << iterations.second << " iterations of about "
            << in_words(seconds) << ", "
            << in_words(SceneEstimate::Range(
                 iterations.first * times.first * seconds,
                 iterations.second * times.second * seconds))
            << '\n';
      }



      void
      print_estimate(Log &log, const SceneEstimate &estimate)
      {
        log << "\nLinear solver  "
            << (estimate.is_factorized ? "direct" : "fiber blocks")
            << "\nMemory         about " << std::fixed << std::setprecision(0)
            << std::ceil(estimate.memory / 1e6) << " MB\n";
        if (estimate.settles())
          {
            log << "Settling       ";
            print_iterations(log,
                             estimate.iterations_to_settle,
                             {1., 1.},
                             estimate.seconds_to_settle);
          }
        const auto [few, many] = estimate.load_steps;
        if (many > 0.)
          {
            log << "Load steps     " << few;
            if (few < many)
              log << " to " << many;
            log << (many > 1. ? ", each " : ", ");
            print_iterations(log,
                             estimate.iterations_of_step,
                             estimate.load_steps,
                             estimate.seconds);
          }
        log << "Time           about " << in_words(estimate.total())
            << " in all" << std::endl;
      }
    } // namespace



    void
    print_description(Log              &log,
                      const Scene      &scene,
                      const Parameters &parameters)
    {
      const SceneEstimate estimate(scene, parameters);
      // Only a fabric is elsewhere when its fibers are embedded.
      require(estimate.matrix.objection.empty() || scene.is_fabric(),
              estimate.matrix.objection);
      print_fibers(log, scene, parameters, estimate.settles());
      if (parameters.matrix.enabled)
        print_matrix(
          log, estimate.matrix, parameters.matrix.material.youngs_modulus);
      for (const auto &notes : {notes_on_units(scene, parameters),
                                notes_on_fibers(scene, parameters)})
        for (const std::string &note : notes)
          log << "Note           " << note << '\n';
      log << "Contributions  ";
      if (scene.stages().empty())
        {
          log << "none: nothing holds or loads the fibers, which are measured "
                 "as they are"
              << std::endl;
          return;
        }
      print_contributions(log, scene, parameters);
      print_estimate(log, estimate);
    }
  } // namespace Simulation
} // namespace Heddle
