#include <heddle/system/unsymmetric_terms.h>

namespace Heddle
{
  namespace System
  {
    void
    UnsymmetricTerms::clear()
    {
      terms.clear();
      term_forces.clear();
      blocks.clear();
      weights.clear();
    }



    void
    UnsymmetricTerms::reserve(const std::size_t n_terms,
                              const std::size_t n_forces,
                              const std::size_t n_blocks)
    {
      terms.reserve(n_terms);
      term_forces.reserve(n_forces);
      blocks.reserve(n_blocks);
      weights.reserve(n_blocks);
    }



    void
    UnsymmetricTerms::begin_term(const Tensor<1, 3> &motion)
    {
      terms.push_back({{motion, static_cast<unsigned int>(blocks.size())},
                       static_cast<unsigned int>(term_forces.size())});
    }



    void
    UnsymmetricTerms::add_motion(const unsigned int block, const double weight)
    {
      blocks.push_back(block);
      weights.push_back(weight);
      terms.back().motion.blocks_end = blocks.size();
    }



    void
    UnsymmetricTerms::begin_force(const Tensor<1, 3> &force)
    {
      term_forces.push_back({force, static_cast<unsigned int>(blocks.size())});
      terms.back().forces_end = term_forces.size();
    }



    void
    UnsymmetricTerms::add_force(const unsigned int block, const double weight)
    {
      blocks.push_back(block);
      weights.push_back(weight);
      term_forces.back().blocks_end = blocks.size();
    }



    void
    UnsymmetricTerms::add_product(const std::vector<Tensor<1, 3>> &motion,
                                  std::vector<Tensor<1, 3>>       &forces) const
    {
      unsigned int k = 0, f = 0;
      for (const Term &term : terms)
        {
          Tensor<1, 3> sum;
          for (; k < term.motion.blocks_end; ++k)
            sum += weights[k] * motion[blocks[k]];
          const double along = term.motion.vector * sum;
          for (; f < term.forces_end; ++f)
            {
              const Tensor<1, 3> force = along * term_forces[f].vector;
              for (; k < term_forces[f].blocks_end; ++k)
                if (blocks[k] < forces.size())
                  forces[blocks[k]] += weights[k] * force;
            }
        }
    }
  } // namespace System
} // namespace Heddle
