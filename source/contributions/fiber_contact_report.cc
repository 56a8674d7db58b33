#include <heddle/base/exceptions.h>
#include <heddle/contributions/fiber_contact.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>
#include <utility>

namespace Heddle
{
  namespace Contributions
  {
    std::vector<unsigned int>
    FiberContact::contacting_fibers(const unsigned int f,
                                    const unsigned int node) const
    {
      const double place = space.node_positions(f)[node],
                   reach = space.fiber(f).length / (space.fiber(f).n_nodes - 1);
      std::set<unsigned int> others;
      for (const Contact::ContactElement &element : contact_elements)
        if (element.force > 0.)
          {
            if (element.fiber_a == f && std::abs(element.s_a - place) < reach)
              others.insert(element.fiber_b);
            if (element.fiber_b == f && std::abs(element.s_b - place) < reach)
              others.insert(element.fiber_a);
          }
      return {others.begin(), others.end()};
    }



    std::string
    FiberContact::objection(const System::State &) const
    {
      if (statistics.deepest <= threshold)
        return "";

      // The rank that has the zone names its fibers.
      double             deepest = -1.;
      std::ostringstream pair;
      for (const Contact::ContactCell &cell : cells.cells())
        {
          const Contact::ContactCells::Zone &zone = cells.zones()[cell.zone];
          if (zone.penetration / zone.radius > deepest)
            {
              deepest = zone.penetration / zone.radius;
              pair.str("");
              pair << "fibers " << cell.fiber_a << " and " << cell.fiber_b;
            }
        }
      const auto where =
        Utilities::MPI::min_max_avg(deepest, space.communicator());
      std::ostringstream text;
      text << std::setprecision(3) << "penetration " << statistics.deepest
           << " of the radius, above " << threshold << ", of "
           << Utilities::MPI::broadcast(
                space.communicator(), pair.str(), where.max_index);
      return text.str();
    }



    std::string
    FiberContact::jam_in_words() const
    {
      double      deepest = threshold;
      std::string pair;
      for (const Contact::ContactCell &cell : cells.cells())
        {
          const Contact::ContactCells::Zone &zone = cells.zones()[cell.zone];
          if (cells.is_stiffest(cell) &&
              zone.penetration / zone.radius > deepest)
            {
              deepest = zone.penetration / zone.radius;
              pair    = std::to_string(cell.fiber_a) + " and " +
                     std::to_string(cell.fiber_b);
            }
        }
      const auto where =
        Utilities::MPI::min_max_avg(deepest, space.communicator());
      pair =
        Utilities::MPI::broadcast(space.communicator(), pair, where.max_index);
      return pair.empty()
               ? ""
               : "fibers " + pair +
                   " are held so near to each other, by supports or by stiff "
                   "neighbours, that no contact force parts them: let them be "
                   "further apart, or raise Contact/Penetration threshold";
    }



    std::string
    FiberContact::status() const
    {
      std::ostringstream text;
      text << "contacts " << static_cast<unsigned long>(statistics.n_watched)
           << " active " << static_cast<unsigned long>(statistics.n_active)
           << std::scientific << std::setprecision(1) << " penetration "
           << statistics.deepest << " penalty " << statistics.least_penalty
           << " to " << statistics.largest_penalty;
      return text.str();
    }



    void
    FiberContact::report(const System::State &,
                         std::map<std::string, double> &values) const
    {
      values["contact_elements[-]"]        = statistics.n_watched;
      values["active_contact_elements[-]"] = statistics.n_active;
      values["mean_contact_force[N]"]      = statistics.mean_force;
      values["max_penetration_ratio[-]"]   = statistics.deepest;
      values["max_indentation_ratio[-]"]   = indented.ratio;
      values["min_penalty[N/mm^2]"]        = statistics.least_penalty;
      values["max_penalty[N/mm^2]"]        = statistics.largest_penalty;
      values["contact_energy[N*mm]"]       = statistics.energy;
      values["contact_hardening[N*mm]"]    = hardening;
    }



    void
    FiberContact::save(ArchiveWriter &archive, const System::State &) const
    {
      Records records;
      records.n_key_parts = 5;
      records.n_values    = 3;
      records.reserve(cells.cells().size());
      for (const Contact::ContactCell &cell : cells.cells())
        if (space.owns(cell.fiber_a))
          {
            records.keys.insert(records.keys.end(),
                                {cell.fiber_a,
                                 cell.fiber_b,
                                 cell.orientation,
                                 cell.level,
                                 cell.number});
            records.values.insert(
              records.values.end(),
              {cell.q_begin, cell.q_end, cell.penalty / cell.kept});
          }
      archive.write(name() + "/cells", std::move(records));
      archive.write_number(name() + "/refinement", refinement);

      Records forgiven;
      forgiven.n_key_parts = 2;
      for (const auto &pair : cells.forgiven_penetrations())
        if (space.owns(pair.first.first))
          {
            forgiven.keys.insert(forgiven.keys.end(),
                                 {pair.first.first, pair.first.second});
            forgiven.values.push_back(pair.second);
          }
      archive.write(name() + "/forgiven penetrations", std::move(forgiven));

      Records forces;
      forces.n_key_parts = 2;
      for (const Force &force : accepted_forces)
        {
          forces.keys.insert(forces.keys.end(),
                             {force.first.first, force.first.second});
          forces.values.push_back(force.second);
        }
      archive.write(name() + "/forces", std::move(forces));
      archive.write_number(name() + "/hardening", hardening);
      archive.write_number(name() + "/largest mean force", largest_mean_force);
      archive.write_number(name() + "/active", accepted_active);
    }



    void
    FiberContact::load(const ArchiveReader &archive, const System::State &)
    {
      const double       before = archive.read_number(name() + "/refinement");
      std::ostringstream sentence;
      sentence << "Contact/Refinement is " << refinement << ", and was "
               << before
               << " in the run that this one goes on from: places of "
                  "contact are numbered by it; leave it as it was.";
      require(before == refinement, sentence.str());
      const Records records = archive.read_records(
        name() + "/cells", [this](const std::int64_t *key) {
          return space.owns(key[0]) || space.owns(key[1]);
        });
      std::vector<Contact::ContactCell> saved;
      for (std::size_t i = 0; i < records.size(); ++i)
        {
          Contact::ContactCell cell = {};
          cell.fiber_a              = records.key(i)[0];
          cell.fiber_b              = records.key(i)[1];
          cell.orientation          = records.key(i)[2];
          cell.level                = records.key(i)[3];
          cell.number               = records.key(i)[4];
          cell.q_begin              = records.value(i)[0];
          cell.q_end                = records.value(i)[1];
          cell.penalty              = records.value(i)[2];
          saved.push_back(cell);
        }
      hardening          = archive.read_number(name() + "/hardening");
      largest_mean_force = archive.read_number(name() + "/largest mean force");
      accepted_active    = archive.read_number(name() + "/active");
      const Records forgiven = archive.read_records(
        name() + "/forgiven penetrations", [this](const std::int64_t *key) {
          return space.owns(key[0]) || space.owns(key[1]);
        });
      Contact::ContactCells::ForgivenPenetrations penetrations;
      for (std::size_t i = 0; i < forgiven.size(); ++i)
        penetrations[{static_cast<unsigned int>(forgiven.key(i)[0]),
                      static_cast<unsigned int>(forgiven.key(i)[1])}] =
          *forgiven.value(i);
      cells.set_cells(saved);
      cells.set_forgiven(penetrations);
      accepted_cells = cells.cells();
      fibers.forget_search();

      accepted_forces.clear();
      const Records forces = archive.read_records(
        name() + "/forces",
        [this](const std::int64_t *key) { return space.owns(key[0]); });
      for (std::size_t i = 0; i < forces.size(); ++i)
        accepted_forces.push_back(
          {{static_cast<unsigned int>(forces.key(i)[0]),
            static_cast<unsigned int>(forces.key(i)[1])},
           *forces.value(i)});
      std::sort(accepted_forces.begin(), accepted_forces.end());
    }
  } // namespace Contributions
} // namespace Heddle
