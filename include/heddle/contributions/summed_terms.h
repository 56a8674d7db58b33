#ifndef heddle_contributions_summed_terms_h
#define heddle_contributions_summed_terms_h

#include <heddle/system/block_system.h>

#include <vector>

namespace Heddle
{
  namespace Contributions
  {
    using namespace dealii;

    /**
     * Sums the terms of elements that follow each other and act on the same
     * blocks, as those of one contact cell do: the system, which has to look
     * for the place of every block, gets them at once.
     */
    class SummedTerms
    {
    public:
      explicit SummedTerms(System::BlockSystem &system);

      /** Whether the system wants a tangent. */
      bool
      wants_tangent() const
      {
        return system.wants_tangent();
      }

      /** From now on terms act on these @p n blocks. */
      void
      begin(const unsigned int n, const unsigned int *blocks);

      /** Where to add terms: 3 n numbers, ... */
      double *
      residual()
      {
        return residual_sum.data();
      }

      /** ... and 3 n rows of 3 n numbers, if the system wants a tangent. */
      double *
      tangent()
      {
        return tangent_sum.data();
      }

      /** Hand over what is left. */
      void
      end();

    private:
      System::BlockSystem      &system;
      std::vector<unsigned int> blocks;
      std::vector<double>       residual_sum, tangent_sum;
    };

    /**
     * Add what a term of PairCouplings does within both sides, one by one, to
     * @p of_a and @p of_b, and the forces that its weights make of @p force.
     */
    template <unsigned int n_of_side>
    void
    add_side_by_side(
      const typename System::PairCouplings<n_of_side>::Blocks &blocks,
      const typename System::PairCouplings<n_of_side>::Term   &term,
      const Tensor<1, 3>                                      &force,
      SummedTerms                                             &of_a,
      SummedTerms                                             &of_b);
  } // namespace Contributions
} // namespace Heddle

#endif
