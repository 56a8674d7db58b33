#include <heddle/simulation/energy_balance.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace Heddle
{
  namespace Simulation
  {
    namespace
    {
      /** From this part of the work on it is worth a sentence [-]. */
      constexpr double large = 0.05;

      /** Work below this part of the energy says little of a fabric [-]. */
      constexpr double little = 0.01;

      bool
      is_energy(const std::string &name)
      {
        const std::string end = "_energy[N*mm]";
        return name.size() > end.size() &&
               name.compare(name.size() - end.size(), end.size(), end) == 0;
      }



      /** Stored and dissipated, less what growing penalties brought [N mm]. */
      double
      energy_in(const EnergyBalance::Report &report)
      {
        double sum = 0.;
        for (const auto &entry : report)
          {
            const std::string &name = entry.first;
            if (name == "contact_hardening[N*mm]" ||
                name == "plate_hardening[N*mm]")
              sum -= entry.second;
            else if (name == "friction_stored[N*mm]" ||
                     name == "friction_dissipated[N*mm]" || is_energy(name))
              sum += entry.second;
          }
        return sum;
      }
    } // namespace



    double
    EnergyBalance::elastic_energy(const Report &report)
    {
      double sum = 0.;
      for (const auto &entry : report)
        sum += is_energy(entry.first) ? entry.second : 0.;
      return sum;
    }



    bool
    EnergyBalance::is_in(const Report &report)
    {
      return report.count(external_work) > 0;
    }



    void
    EnergyBalance::begin(const Report &report)
    {
      energy = energy_in(report);
      work   = report.at(external_work);
      sum = path = 0.;
      begun      = true;
    }



    void
    EnergyBalance::add(const Report &report)
    {
      if (!begun)
        return begin(report);
      const double energy_before = energy, work_before = work;
      energy = energy_in(report);
      work   = report.at(external_work);
      sum += energy - energy_before - (work - work_before);
      path += std::abs(work - work_before);
    }



    std::string
    EnergyBalance::in_words(const double round_off) const
    {
      if (std::abs(sum) <= round_off ||
          std::abs(sum) <= large * std::max(path, little * std::abs(energy)))
        return "";
      std::ostringstream text;
      text << std::setprecision(2) << std::abs(sum) << " N mm";
      if (path > 0.)
        text << ", " << 100. * std::abs(sum) / path << " % of the work,";
      if (sum < 0.)
        text
          << " is in no energy: steps are too long, or, if more of them do not "
             "mend it, fibers have snapped from one equilibrium to another";
      else
        text << " was not done by supports, loads or plates, and is in the "
                "energies: "
                "steps are too long";
      text << " (history.csv, energy_imbalance)";
      return text.str();
    }



    void
    EnergyBalance::save(ArchiveWriter &archive) const
    {
      archive.write_number("energy balance/begun", begun);
      archive.write_number("energy balance/energy", energy);
      archive.write_number("energy balance/work", work);
      archive.write_number("energy balance/sum", sum);
      archive.write_number("energy balance/path", path);
    }



    void
    EnergyBalance::load(const ArchiveReader &archive)
    {
      begun  = archive.read_number("energy balance/begun") > 0.;
      energy = archive.read_number("energy balance/energy");
      work   = archive.read_number("energy balance/work");
      sum    = archive.read_number("energy balance/sum");
      path   = archive.read_number("energy balance/path");
    }
  } // namespace Simulation
} // namespace Heddle
