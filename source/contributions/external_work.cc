#include <heddle/contributions/external_work.h>
#include <heddle/system/block_archive.h>

#include <deal.II/base/mpi.h>

namespace Heddle
{
  namespace Contributions
  {
    void
    ExternalWork::add_step(const System::State &state)
    {
      before.resize(now.size());
      double sum = 0.;
      for (unsigned int b = 0; b < now.size(); ++b)
        sum += 0.5 * (before[b] + now[b]) *
               (state.current()[b] - state.accepted()[b]);
      work += Utilities::MPI::sum(sum, state.space.communicator());
      before = now;
    }



    void
    ExternalWork::save(ArchiveWriter       &archive,
                       const std::string   &name,
                       const System::State &state) const
    {
      System::write_blocks(archive, name + "/forces", state, before);
      archive.write_number(name + "/work", work);
    }



    void
    ExternalWork::load(const ArchiveReader &archive,
                       const std::string   &name,
                       const System::State &state)
    {
      before = System::read_blocks(archive, name + "/forces", state);
      now    = before;
      work   = archive.read_number(name + "/work");
    }
  } // namespace Contributions
} // namespace Heddle
