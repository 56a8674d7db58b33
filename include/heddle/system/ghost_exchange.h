#ifndef heddle_system_ghost_exchange_h
#define heddle_system_ghost_exchange_h

#include <deal.II/base/tensor.h>

#include <mpi.h>

#include <map>
#include <vector>

namespace Heddle
{
  namespace System
  {
    using namespace dealii;

    /** Consecutive blocks of an array. */
    struct Piece
    {
      unsigned int begin;
      unsigned int n;
    };

    /**
     * Brings the values of blocks from the ranks that own them to those that
     * hold copies.
     */
    class GhostExchange
    {
    public:
      GhostExchange(const MPI_Comm communicator)
        : communicator(communicator)
      {
      }

      /** By rank: what it is sent, in the order in which it expects that. */
      std::map<unsigned int, std::vector<Piece>> sent;

      /** By rank: where in the array that which comes from it goes. */
      std::map<unsigned int, Piece> received;

      /**
       * Fetch the values of all copies.
       * @note Collective.
       */
      void
      update(std::vector<Tensor<1, 3>> &values) const;

    private:
      /** Put what is sent into the buffer, rank by rank. */
      void
      collect(const std::vector<Tensor<1, 3>> &values) const;

      static unsigned int
      n_blocks(const std::vector<Piece> &pieces);

      const MPI_Comm communicator;

      // Every product with a matrix fetches copies: memory is kept from one
      // time to the next.
      mutable std::vector<Tensor<1, 3>> buffer;
      mutable std::vector<MPI_Request>  requests;
    };
  } // namespace System
} // namespace Heddle

#endif
