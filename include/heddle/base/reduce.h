#ifndef heddle_base_reduce_h
#define heddle_base_reduce_h

#include <mpi.h>

#include <type_traits>
#include <vector>

namespace Heddle
{
  namespace internal
  {
    namespace Reduce
    {
      /** Reduce @p n objects that are made of nothing but doubles. */
      template <typename Numbers>
      void
      reduce(Numbers          *values,
             const std::size_t n,
             const MPI_Op      operation,
             const MPI_Comm    communicator)
      {
        static_assert(std::is_standard_layout<Numbers>::value &&
                        alignof(Numbers) == alignof(double) &&
                        sizeof(Numbers) % sizeof(double) == 0,
                      "What is reduced over ranks must be made of doubles.");
        MPI_Allreduce(MPI_IN_PLACE,
                      values,
                      n * (sizeof(Numbers) / sizeof(double)),
                      MPI_DOUBLE,
                      operation,
                      communicator);
      }
    } // namespace Reduce
  }   // namespace internal



  /**
   * Replace all numbers of @p values, a structure of doubles, arrays and
   * tensors of doubles, by their sums over all ranks. @note Collective.
   */
  template <typename Numbers>
  void
  sum_over_ranks(Numbers &values, const MPI_Comm communicator)
  {
    internal::Reduce::reduce(&values, 1, MPI_SUM, communicator);
  }



  /** Likewise for a list, as long on all ranks. @note Collective. */
  template <typename Numbers>
  void
  sum_over_ranks(std::vector<Numbers> &values, const MPI_Comm communicator)
  {
    internal::Reduce::reduce(
      values.data(), values.size(), MPI_SUM, communicator);
  }



  /** Replace all numbers of @p values by the largest over all ranks.
   * @note Collective. */
  template <typename Numbers>
  void
  max_over_ranks(Numbers &values, const MPI_Comm communicator)
  {
    internal::Reduce::reduce(&values, 1, MPI_MAX, communicator);
  }
} // namespace Heddle

#endif
