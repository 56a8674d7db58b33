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
     * The part of a tangent that is not symmetric, as a sum of products
     * @f$f g^T@f$ of two vectors with few blocks: a motion x raises the forces
     * @f$f (g \cdot x)@f$. It is kept as it is and only ever multiplied with a
     * motion: its matrix would have many times as many numbers.
     */
    class UnsymmetricTerms
    {
    public:
      /** One block of a vector. */
      struct Entry
      {
        unsigned int block; /**< local number */
        Tensor<1, 3> value;
      };

      void
      clear();

      /** Have room for so many terms, and blocks of their vectors. */
      void
      reserve(const std::size_t n_terms,
              const std::size_t n_forces,
              const std::size_t n_motions);

      bool
      empty() const
      {
        return terms.empty();
      }

      /** Begin a term, whose vectors then are added to block by block. */
      void
      add_term();

      void
      add_force(const unsigned int block, const Tensor<1, 3> &value);

      void
      add_motion(const unsigned int block, const Tensor<1, 3> &value);

      /**
       * Add to @p forces, those of the blocks that it has, what is raised by
       * @p motion of all local blocks.
       */
      void
      add_product(const std::vector<Tensor<1, 3>> &motion,
                  std::vector<Tensor<1, 3>>       &forces) const;

    private:
      /** Where the entries of a term end. */
      struct Term
      {
        unsigned int forces_end, motions_end;
      };

      std::vector<Term>  terms;
      std::vector<Entry> forces, motions;
    };
  } // namespace System
} // namespace Heddle

#endif
