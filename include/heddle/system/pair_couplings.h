#ifndef heddle_system_pair_couplings_h
#define heddle_system_pair_couplings_h

#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <vector>

namespace Heddle
{
  namespace System
  {
    using namespace dealii;

    /**
     * What couples the particles of two fibers, or two of one fiber, in a
     * symmetric tangent, kept as the few numbers that it is made of. A term has
     * @p n_of_side blocks, with a weight each, on either side, a and b, and a
     * stiffness k: a motion x raises the forces
     * @f$f_i = w_i k \sum_j w_j x_j@f$, with i on one side and j on the other.
     * In a matrix that would be 9 numbers for each pair of blocks, and fibers
     * that move would ask for another pattern.
     *
     * What a term couples within a side has its place in the matrix.
     */
    template <unsigned int n_of_side>
    class PairCouplings
    {
    public:
      using Blocks  = std::array<unsigned int, 2 * n_of_side>;
      using Weights = std::array<double, 2 * n_of_side>;

      struct Term
      {
        Weights               weights;
        SymmetricTensor<2, 3> stiffness;
      };

      void
      clear();

      bool
      empty() const
      {
        return terms.empty();
      }

      /**
       * Have room for @p n_terms in all, which must be none yet: grown one by
       * one they take up to twice as much.
       */
      void
      reserve(const std::size_t n_terms);

      /** Add a term; cheapest if the one before has the same @p blocks. */
      void
      add_term(const Blocks &blocks, const Term &term);

      /**
       * Add to @p forces, those of the blocks that it has, what is raised by
       * @p motion of all local blocks.
       */
      void
      add_product(const std::vector<Tensor<1, 3>> &motion,
                  std::vector<Tensor<1, 3>>       &forces) const;

      /** Call @p action(blocks, first, end) for the terms of the same blocks.
       */
      template <typename Action>
      void
      for_each_group(const Action &action) const;

    private:
      /** Terms between the same blocks, up to @p end. */
      struct Group
      {
        Blocks       blocks;
        unsigned int end;
      };

      std::vector<Group> groups;
      std::vector<Term>  terms;
    };

    /** What normal forces couple: the axes of two fibers. */
    using AxisCouplings = PairCouplings<4>;

    /** What friction couples: the axes of two fibers, and their sections. */
    using SectionCouplings = PairCouplings<8>;



    template <unsigned int n_of_side>
    template <typename Action>
    void
    PairCouplings<n_of_side>::for_each_group(const Action &action) const
    {
      const Term *first = terms.data();
      for (const Group &group : groups)
        {
          const Term *end = terms.data() + group.end;
          action(group.blocks, first, end);
          first = end;
        }
    }
  } // namespace System
} // namespace Heddle

#endif
