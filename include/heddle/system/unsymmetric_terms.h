#ifndef heddle_system_unsymmetric_terms_h
#define heddle_system_unsymmetric_terms_h

#include <deal.II/base/tensor.h>

#include <vector>

namespace Heddle
{
  namespace System
  {
    using namespace dealii;

    /**
     * The part of a tangent that is not symmetric, as a sum of products: a
     * motion x raises the forces
     * @f$f_i = v_i F \, (G \cdot \sum_j w_j x_j)@f$ with weights of few blocks
     * i and j, a vector G, and one or more vectors F with blocks of their own.
     * It is kept as it is and only ever multiplied with a motion: its matrix
     * would have many times as many numbers.
     */
    class UnsymmetricTerms
    {
    public:
      void
      clear();

      /**
       * Have room for so many terms, vectors F, and blocks of both kinds
       * together.
       */
      void
      reserve(const std::size_t n_terms,
              const std::size_t n_forces,
              const std::size_t n_blocks);

      bool
      empty() const
      {
        return terms.empty();
      }

      /** Begin a term with the vector G, ... */
      void
      begin_term(const Tensor<1, 3> &motion);

      /** ... of the blocks whose motion counts: all of these come first; */
      void
      add_motion(const unsigned int block, const double weight);

      /** ... then come the vectors F, each of them ... */
      void
      begin_force(const Tensor<1, 3> &force);

      /** ... with the blocks that it acts on. */
      void
      add_force(const unsigned int block, const double weight);

      /**
       * Add to @p forces, those of the blocks that it has, what is raised by
       * @p motion of all local blocks.
       */
      void
      add_product(const std::vector<Tensor<1, 3>> &motion,
                  std::vector<Tensor<1, 3>>       &forces) const;

    private:
      /** A vector, and where its blocks end. */
      struct Weighted
      {
        Tensor<1, 3> vector;
        unsigned int blocks_end;
      };

      struct Term
      {
        Weighted     motion;
        unsigned int forces_end;
      };

      std::vector<Term>         terms;
      std::vector<Weighted>     term_forces;
      std::vector<unsigned int> blocks;
      std::vector<double>       weights;
    };
  } // namespace System
} // namespace Heddle

#endif
