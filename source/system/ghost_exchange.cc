#include <heddle/system/ghost_exchange.h>

namespace Heddle
{
  namespace System
  {
    void
    GhostExchange::update(std::vector<Tensor<1, 3>> &values) const
    {
      std::vector<MPI_Request>               requests;
      std::vector<std::vector<Tensor<1, 3>>> buffers;
      buffers.reserve(sent.size());
      for (const auto &from : received)
        {
          requests.emplace_back();
          MPI_Irecv(values.data() + from.second.begin,
                    3 * from.second.n,
                    MPI_DOUBLE,
                    from.first,
                    0,
                    communicator,
                    &requests.back());
        }
      for (const auto &to : sent)
        {
          buffers.emplace_back();
          for (const Piece &piece : to.second)
            buffers.back().insert(buffers.back().end(),
                                  values.begin() + piece.begin,
                                  values.begin() + piece.begin + piece.n);
          requests.emplace_back();
          MPI_Isend(buffers.back().data(),
                    3 * buffers.back().size(),
                    MPI_DOUBLE,
                    to.first,
                    0,
                    communicator,
                    &requests.back());
        }
      MPI_Waitall(requests.size(), requests.data(), MPI_STATUSES_IGNORE);
    }
  } // namespace System
} // namespace Heddle
