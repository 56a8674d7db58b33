#include <heddle/simulation/own_tangents.h>
#include <heddle/solver/tangent_error.h>

#include <algorithm>
#include <iomanip>
#include <limits>
#include <sstream>

namespace Heddle
{
  namespace Simulation
  {
    void
    print_own_tangents(Log &log, const Scene &scene)
    {
      // Differences over short ways have round-off, those over long ones
      // curvature: one of them tells.
      constexpr double wrong = 1e-3;
      for (const auto &own : scene.own_contributions())
        {
          double error = std::numeric_limits<double>::max();
          for (const double motion : {1e-3, 1e-4, 1e-5, 1e-6})
            {
              System::State start(scene.space());
              start.set(scene.initial());
              start.load_factor = 1.;
              own->begin_stage(start);
              own->begin_step(start);
              error =
                std::min(error, Solver::tangent_error(own, start, motion));
            }
          std::ostringstream text;
          text << std::scientific << std::setprecision(1) << error
               << " off the derivative of its residual where fibers start";
          if (error > wrong)
            log << "Note           the tangent of '" << own->name() << "' is "
                << text.str()
                << ": searches take many iterations with it; see whether both "
                   "belong together, and whether what is not symmetric is in "
                   "BlockSystem::unsymmetric_terms"
                << std::endl;
          else
            log << "Tangent        of '" << own->name() << "', " << text.str()
                << std::endl;
        }
    }
  } // namespace Simulation
} // namespace Heddle
