#include <heddle/base/exceptions.h>
#include <heddle/solver/load_stepping.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Heddle
{
  namespace Solver
  {
    namespace
    {
      /** Load factors closer than this are one. */
      constexpr double tiny = 1e-12;

      /** Points so close to each other are one. */
      constexpr double same_point = 1e-6;

      /** Good steps after a cut before it is forgotten. */
      constexpr unsigned int first_patience = 3;
    } // namespace



    LoadSteppingParameters::LoadSteppingParameters(const std::string &section)
      : ParameterAcceptor(section)
    {
      entries.initial_step  = 0.1;
      entries.smallest_step = 1e-4;
      add_parameter("Initial step",
                    entries.initial_step,
                    "First step of the load factor, which goes from 0 to 1. "
                    "Inactive without loads and supports, like all of this "
                    "section [-].",
                    prm,
                    Patterns::Double(1e-9, 1.));
      add_parameter("Largest step",
                    entries.largest_step,
                    "No step is longer, however easy the last one was [-].",
                    prm,
                    Patterns::Double(1e-9, 1.));
      add_parameter("Smallest step",
                    entries.smallest_step,
                    "Steps are halved while no equilibrium is found, and the "
                    "run is given up when they would get shorter than this "
                    "[-].",
                    prm,
                    Patterns::Double(1e-9, 1.));
      add_parameter("Easy iterations",
                    entries.easy_iterations,
                    "After a step of at most this many Newton iterations the "
                    "next one is half as long again [-].",
                    prm,
                    Patterns::Integer(0));
      add_parameter("Points",
                    entries.points,
                    "Load factors between 0 and 1 that are reached exactly, "
                    "in ascending order, as in '0.25, 0.5' [-].");
    }



    LoadPlan
    LoadSteppingParameters::plan() const
    {
      const auto text = [](const double value) {
        std::ostringstream out;
        out << value;
        return out.str();
      };
      require(entries.smallest_step <= entries.initial_step &&
                entries.initial_step <= entries.largest_step,
              "Load stepping: the initial step is " +
                text(entries.initial_step) + "; it must lie between the " +
                "smallest, " + text(entries.smallest_step) +
                ", and the largest, " + text(entries.largest_step) + ".");
      double before = 0.;
      for (const double point : entries.points)
        {
          require(point > before + tiny && point < 1. + tiny,
                  "Load stepping: the point " + text(point) +
                    " is not between " + text(before) +
                    " and 1; list the points in ascending order.");
          before = point;
        }
      return entries;
    }



    void
    LoadPlan::reach(const std::vector<double> &more)
    {
      points.insert(points.end(), more.begin(), more.end());
      std::sort(points.begin(), points.end());
      points.erase(std::unique(points.begin(),
                               points.end(),
                               [](const double one, const double next) {
                                 return next - one < same_point;
                               }),
                   points.end());
    }



    LoadStepping::LoadStepping(const LoadPlan &plan)
      : plan(plan)
      , step(plan.initial_step)
    {
    }



    double
    LoadStepping::next_point() const
    {
      for (const double point : plan.points)
        if (point > last + tiny)
          return std::min(point, 1.);
      return 1.;
    }



    unsigned int
    LoadStepping::n_steps_to(const double point) const
    {
      return std::max(1., std::ceil((point - last) / step - 1e-6));
    }



    double
    LoadStepping::next() const
    {
      if (at_zero)
        return 0.;
      const double       point = next_point();
      const unsigned int n     = n_steps_to(point);
      return n == 1 ? point : last + (point - last) / n;
    }



    void
    LoadStepping::accept(const unsigned int newton_iterations)
    {
      last  = next();
      begun = true;
      if (at_zero)
        {
          at_zero = false;
          return;
        }

      // Where it has failed again easy steps are trusted no more than twice as
      // far as others: each failure costs as much as many steps.
      // A step's length beyond that place this is over.
      if (last > failed + uncut)
        patience = first_patience;
      const bool is_easy = newton_iterations <= plan.easy_iterations;
      const bool trusted = step >= uncut || patience == first_patience;
      n_good += is_easy ? 2 : 1;
      if (is_easy && trusted)
        step = std::min(1.5 * step, plan.largest_step);
      else if (n_good >= patience && step < uncut)
        {
          step   = std::min(1.5 * step, uncut);
          n_good = 0;
        }
    }



    bool
    LoadStepping::cut_back()
    {
      if (at_zero)
        return false;
      // What failed may be shorter than what was meant.
      const double shorter = 0.5 * (next() - last);
      if (shorter < plan.smallest_step * (1. - 1e-6))
        return false;

      // If it was cut before, it has to be good for twice as long.
      if (step >= uncut)
        patience = first_patience;
      else if (n_good > 0)
        patience *= 2;
      failed = next();
      uncut  = std::max(uncut, step);
      step   = shorter;
      n_good = 0;
      return true;
    }



    void
    LoadStepping::save(ArchiveWriter &archive) const
    {
      archive.write_number("load stepping/begun", begun);
      archive.write_number("load stepping/reached", last);
      archive.write_number("load stepping/step", step);
      archive.write_number("load stepping/uncut", uncut);
      archive.write_number("load stepping/failed", failed);
      archive.write_number("load stepping/n_good", n_good);
      archive.write_number("load stepping/patience", patience);
    }



    void
    LoadStepping::load(const ArchiveReader &archive)
    {
      last  = archive.read_number("load stepping/reached");
      begun = archive.read_number("load stepping/begun") > 0.;
      step =
        std::min(archive.read_number("load stepping/step"), plan.largest_step);
      uncut =
        std::min(archive.read_number("load stepping/uncut"), plan.largest_step);
      failed   = archive.read_number("load stepping/failed");
      n_good   = archive.read_number("load stepping/n_good");
      patience = archive.read_number("load stepping/patience");
    }
  } // namespace Solver
} // namespace Heddle
