#include <heddle/system/unsymmetric_terms.h>

#include <deal.II/base/exceptions.h>

namespace Heddle
{
  namespace System
  {
    void
    UnsymmetricTerms::clear()
    {
      terms.clear();
      blocks.clear();
      weights.clear();
    }



    void
    UnsymmetricTerms::reserve(const std::size_t n_terms,
                              const std::size_t n_blocks)
    {
      terms.reserve(n_terms);
      blocks.reserve(n_blocks);
      weights.reserve(n_blocks);
    }



    void
    UnsymmetricTerms::add_term(const Tensor<1, 3> &force,
                               const Tensor<1, 3> &motion)
    {
      const unsigned int n = blocks.size();
      terms.push_back({force, motion, n, n});
    }



    void
    UnsymmetricTerms::add_motion(const unsigned int block, const double weight)
    {
      Assert(terms.back().forces_end == terms.back().motions_end,
             ExcMessage("Forces come after motions."));
      blocks.push_back(block);
      weights.push_back(weight);
      terms.back().forces_end = terms.back().motions_end = blocks.size();
    }



    void
    UnsymmetricTerms::add_force(const unsigned int block, const double weight)
    {
      blocks.push_back(block);
      weights.push_back(weight);
      terms.back().forces_end = blocks.size();
    }



    void
    UnsymmetricTerms::add_product(const std::vector<Tensor<1, 3>> &motion,
                                  std::vector<Tensor<1, 3>>       &forces) const
    {
      unsigned int k = 0;
      for (const Term &term : terms)
        {
          Tensor<1, 3> sum;
          for (; k < term.motions_end; ++k)
            sum += weights[k] * motion[blocks[k]];
          const Tensor<1, 3> force = (term.motion * sum) * term.force;
          for (; k < term.forces_end; ++k)
            if (blocks[k] < forces.size())
              forces[blocks[k]] += weights[k] * force;
        }
    }
  } // namespace System
} // namespace Heddle
