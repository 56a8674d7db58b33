#include <heddle/system/state.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <map>

namespace Heddle
{
  namespace System
  {
    State::State(const FiberSpace &space)
      : space(space)
      , owned_blocks(space.owned_blocks().second - space.owned_blocks().first)
      , blocks(owned_blocks)
      , accepted_blocks(owned_blocks)
      , local_begin(space.n_fibers(), absent)
      , sent(Utilities::MPI::n_mpi_processes(space.communicator()))
      , received(sent.size())
    {
      const auto owned = space.owned_fibers();
      for (unsigned int f = owned.first; f < owned.second; ++f)
        local_begin[f] = space.first_block(f) - space.owned_blocks().first;
    }



    void
    State::set_ghost_fibers(const std::vector<unsigned int> &fibers)
    {
      for (const unsigned int f : ghosts)
        local_begin[f] = absent;
      ghosts = fibers;
      ++version;

      std::map<unsigned int, std::vector<unsigned int>> wanted;
      unsigned int                                      end = owned_blocks;
      for (const unsigned int f : ghosts)
        {
          Assert(!space.owns(f), ExcMessage("An owned fiber is no ghost."));
          local_begin[f] = end;
          end += space.n_blocks(f);
          wanted[space.owner(f)].push_back(f);
        }
      blocks.resize(end);
      accepted_blocks.resize(end);

      for (unsigned int rank = 0; rank < sent.size(); ++rank)
        {
          sent[rank].clear();
          received[rank].clear();
        }
      for (const auto &request : wanted)
        received[request.first] = request.second;
      for (const auto &request :
           Utilities::MPI::some_to_some(space.communicator(), wanted))
        sent[request.first] = request.second;

      update_ghosts();
      update_ghosts(accepted_blocks);
    }



    void
    State::update_ghosts()
    {
      update_ghosts(blocks);
    }



    void
    State::update_ghosts(std::vector<Tensor<1, 3>> &values) const
    {
      AssertDimension(values.size(), blocks.size());
      std::vector<MPI_Request>               requests;
      std::vector<std::vector<Tensor<1, 3>>> buffers;
      buffers.reserve(sent.size());

      // Ghosts of one rank are consecutive here, so they are received in place.
      for (unsigned int rank = 0; rank < received.size(); ++rank)
        if (!received[rank].empty())
          {
            unsigned int n = 0;
            for (const unsigned int f : received[rank])
              n += space.n_blocks(f);
            requests.emplace_back();
            MPI_Irecv(values.data() + local_begin[received[rank].front()],
                      3 * n,
                      MPI_DOUBLE,
                      rank,
                      0,
                      space.communicator(),
                      &requests.back());
          }
      for (unsigned int rank = 0; rank < sent.size(); ++rank)
        if (!sent[rank].empty())
          {
            buffers.emplace_back();
            for (const unsigned int f : sent[rank])
              buffers.back().insert(buffers.back().end(),
                                    values.begin() + local_begin[f],
                                    values.begin() + local_begin[f] +
                                      space.n_blocks(f));
            requests.emplace_back();
            MPI_Isend(buffers.back().data(),
                      3 * buffers.back().size(),
                      MPI_DOUBLE,
                      rank,
                      0,
                      space.communicator(),
                      &requests.back());
          }
      MPI_Waitall(requests.size(), requests.data(), MPI_STATUSES_IGNORE);
    }



    void
    State::move(const double factor, const std::vector<Tensor<1, 3>> &increment)
    {
      AssertDimension(increment.size(), blocks.size());
      for (unsigned int i = 0; i < blocks.size(); ++i)
        blocks[i] += factor * increment[i];
    }



    void
    State::accept()
    {
      accepted_blocks = blocks;
    }



    void
    State::reject()
    {
      blocks = accepted_blocks;
    }
  } // namespace System
} // namespace Heddle
