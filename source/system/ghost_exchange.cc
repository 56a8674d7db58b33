#include <heddle/system/ghost_exchange.h>

#include <deal.II/base/exceptions.h>

namespace Heddle
{
  namespace System
  {
    void
    GhostExchange::update(std::vector<Tensor<1, 3>> &values) const
    {
      requests.clear();
      for (const auto &from : received)
        {
          const int ierr = MPI_Irecv(values.data() + from.second.begin,
                                     3 * from.second.n,
                                     MPI_DOUBLE,
                                     from.first,
                                     0,
                                     communicator,
                                     &requests.emplace_back());
          AssertThrowMPI(ierr);
        }
      collect(values);
      const Tensor<1, 3> *begin = buffer.data();
      for (const auto &to : sent)
        {
          const unsigned int n    = n_blocks(to.second);
          const int          ierr = MPI_Isend(begin,
                                     3 * n,
                                     MPI_DOUBLE,
                                     to.first,
                                     0,
                                     communicator,
                                     &requests.emplace_back());
          AssertThrowMPI(ierr);
          begin += n;
        }
      const int ierr =
        MPI_Waitall(requests.size(), requests.data(), MPI_STATUSES_IGNORE);
      AssertThrowMPI(ierr);
    }



    void
    GhostExchange::collect(const std::vector<Tensor<1, 3>> &values) const
    {
      buffer.clear();
      for (const auto &to : sent)
        for (const Piece &piece : to.second)
          buffer.insert(buffer.end(),
                        values.begin() + piece.begin,
                        values.begin() + piece.begin + piece.n);
    }



    unsigned int
    GhostExchange::n_blocks(const std::vector<Piece> &pieces)
    {
      unsigned int n = 0;
      for (const Piece &piece : pieces)
        n += piece.n;
      return n;
    }
  } // namespace System
} // namespace Heddle
