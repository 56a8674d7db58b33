#include <heddle/contributions/external_work.h>
#include <heddle/system/block_archive.h>

#include <deal.II/base/mpi.h>
#include <deal.II/physics/transformations.h>

namespace Heddle
{
  namespace Contributions
  {
    void
    ExternalWork::add_step(const System::State     &state,
                           const std::vector<Turn> &turns)
    {
      before.resize(now.size());
      double sum = 0.;
      for (unsigned int b = 0; b < now.size(); ++b)
        sum += 0.5 * (before[b] + now[b]) *
               (state.current()[b] - state.accepted()[b]);
      for (const Turn &turn : turns)
        {
          const double angle = turn.rotation.norm();
          if (angle == 0.)
            continue;
          const Tensor<1, 3> &was = before[turn.block], &is = now[turn.block];
          const Tensor<1, 3>  lever =
            Physics::Transformations::Rotations::rotation_matrix_3d(
              turn.rotation / angle, angle) *
            turn.lever;
          sum +=
            0.5 *
            ((cross_product_3d(turn.lever, was) + cross_product_3d(lever, is)) *
               turn.rotation -
             (was + is) * (lever - turn.lever));
        }
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
