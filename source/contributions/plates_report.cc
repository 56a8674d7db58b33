// What plates report, save and are drawn by.
#include <heddle/base/reduce.h>
#include <heddle/contributions/plates.h>
#include <heddle/contributions/volume_in_box.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <iomanip>
#include <limits>
#include <sstream>

namespace Heddle
{
  namespace Contributions
  {
    double
    Plates::energy_of_hardening() const
    {
      // As FiberContact has it, for the force of each fiber on a plate.
      double sum = 0.;
      for (unsigned int k = 0; k < touches.size(); ++k)
        if (touches[k].force > 0.)
          sum += touches[k].energy * (touches[k].hardened - 1.) *
                 accepted_touches[k].force / touches[k].force;
      return Utilities::MPI::sum(sum, space.communicator());
    }



    std::string
    Plates::status() const
    {
      std::ostringstream text;
      text << "plates " << std::scientific << std::setprecision(1)
           << 0.5 * (sums.force[0] + sums.force[1]) << " N";
      return text.str();
    }



    void
    Plates::report(const System::State           &state,
                   std::map<std::string, double> &values) const
    {
      const double force    = 0.5 * (accepted_force[0] + accepted_force[1]);
      const double distance = accepted_positions[1] - accepted_positions[0];
      values["plate_distance[mm]"] = distance;
      values["plate_force[N]"]     = force;
      if (covered)
        {
          values["plate_pressure[MPa]"]      = force / covered->volume();
          values["plate_volume_fraction[-]"] = volume_fraction(state);
        }
      values["plate_energy[N*mm]"]             = sums.energy;
      values["plate_hardening[N*mm]"]          = hardening;
      values["max_plate_penetration_ratio[-]"] = deepest;
      values["external_work[N*mm]"] += work;
    }



    BoundingBox<2>
    Plates::extent(const System::State &state) const
    {
      if (covered)
        return *covered;
      // Largest values: what is least is turned round.
      std::array<double, 4> most;
      most.fill(-std::numeric_limits<double>::max());
      const auto owned = space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        for (unsigned int i = 0; i < space.fiber(f).n_nodes; ++i)
          for (unsigned int d = 0; d < 2; ++d)
            {
              const double x = state.fiber(f)[i * space.n_blocks_per_node()][d];
              const double radius = space.fiber(f).radius;
              most[d]             = std::max(most[d], radius - x);
              most[2 + d]         = std::max(most[2 + d], radius + x);
            }
      max_over_ranks(most, space.communicator());
      return BoundingBox<2>(
        {Point<2>(-most[0], -most[1]), Point<2>(most[2], most[3])});
    }



    double
    Plates::volume_fraction(const System::State &state) const
    {
      if (!are_placed())
        return std::numeric_limits<double>::quiet_NaN();
      const BoundingBox<3> box({Point<3>(covered->lower_bound(0),
                                         covered->lower_bound(1),
                                         accepted_positions[0]),
                                Point<3>(covered->upper_bound(0),
                                         covered->upper_bound(1),
                                         accepted_positions[1])});
      return Utilities::MPI::sum(volume_in_box(state, box),
                                 space.communicator()) /
             box.volume();
    }



    void
    Plates::save(ArchiveWriter &archive, const System::State &) const
    {
      std::vector<double> rows;
      for (const Touch &touch : accepted_touches)
        rows.insert(rows.end(),
                    {touch.begin, touch.end, touch.penalty, touch.force});
      archive.write(name() + "/touches",
                    n_plates * space.owned_fibers().first,
                    n_plates * space.n_fibers(),
                    rows,
                    4);
      for (unsigned int plate = 0; plate < n_plates; ++plate)
        {
          const std::string of = name() + (plate == 0 ? "/lower" : "/upper");
          archive.write_number(of + " begin", begin[plate]);
          archive.write_number(of + " position", accepted_positions[plate]);
          archive.write_number(of + " force", accepted_force[plate]);
        }
      archive.write_number(name() + "/stretches", accepted_stretches);
      archive.write_number(name() + "/largest mean force", largest_mean_force);
      archive.write_number(name() + "/work", work);
      archive.write_number(name() + "/hardening", hardening);
    }



    void
    Plates::load(const ArchiveReader &archive, const System::State &)
    {
      const std::vector<double> rows =
        archive.read(name() + "/touches",
                     n_plates * space.owned_fibers().first,
                     touches.size(),
                     4);
      for (unsigned int k = 0; k < touches.size(); ++k)
        {
          touches[k].begin   = rows[4 * k];
          touches[k].end     = rows[4 * k + 1];
          touches[k].penalty = rows[4 * k + 2];
          touches[k].force   = rows[4 * k + 3];
        }
      accepted_touches = touches;
      for (unsigned int plate = 0; plate < n_plates; ++plate)
        {
          const std::string of = name() + (plate == 0 ? "/lower" : "/upper");
          begin[plate]         = archive.read_number(of + " begin");
          accepted_positions[plate] = archive.read_number(of + " position");
          accepted_force[plate]     = archive.read_number(of + " force");
        }
      accepted_stretches = archive.read_number(name() + "/stretches");
      largest_mean_force = archive.read_number(name() + "/largest mean force");
      work               = archive.read_number(name() + "/work");
      hardening          = archive.read_number(name() + "/hardening");
    }
  } // namespace Contributions
} // namespace Heddle
