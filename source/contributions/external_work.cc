#include <heddle/contributions/external_work.h>

#include <deal.II/base/mpi.h>

namespace Heddle
{
  namespace Contributions
  {
    ExternalWork::ExternalWork(const System::FiberSpace &space)
      : space(space)
      , before(space.owned_blocks().second - space.owned_blocks().first)
      , now(before)
    {
    }



    void
    ExternalWork::add_step(const System::State &state)
    {
      double sum = 0.;
      for (unsigned int b = 0; b < now.size(); ++b)
        sum += 0.5 * (before[b] + now[b]) *
               (state.current()[b] - state.accepted()[b]);
      work += Utilities::MPI::sum(sum, space.communicator());
      before = now;
    }



    void
    ExternalWork::save(ArchiveWriter &archive, const std::string &name) const
    {
      std::vector<double> values;
      for (const Tensor<1, 3> &force : before)
        values.insert(values.end(), force.begin_raw(), force.end_raw());
      archive.write(name + "/forces",
                    space.owned_blocks().first,
                    space.n_blocks(),
                    values,
                    3);
      archive.write_number(name + "/work", work);
    }



    void
    ExternalWork::load(const ArchiveReader &archive, const std::string &name)
    {
      const std::vector<double> values = archive.read(
        name + "/forces", space.owned_blocks().first, before.size(), 3);
      for (unsigned int b = 0; b < before.size(); ++b)
        for (unsigned int d = 0; d < 3; ++d)
          before[b][d] = values[3 * b + d];
      now  = before;
      work = archive.read_number(name + "/work");
    }
  } // namespace Contributions
} // namespace Heddle
