#include <heddle/system/unsymmetric_terms.h>

namespace Heddle
{
  namespace System
  {
    void
    UnsymmetricTerms::clear()
    {
      terms.clear();
      forces.clear();
      motions.clear();
    }



    void
    UnsymmetricTerms::reserve(const std::size_t n_terms,
                              const std::size_t n_forces,
                              const std::size_t n_motions)
    {
      terms.reserve(n_terms);
      forces.reserve(n_forces);
      motions.reserve(n_motions);
    }



    void
    UnsymmetricTerms::add_term()
    {
      terms.push_back({static_cast<unsigned int>(forces.size()),
                       static_cast<unsigned int>(motions.size())});
    }



    void
    UnsymmetricTerms::add_force(const unsigned int  block,
                                const Tensor<1, 3> &value)
    {
      forces.push_back({block, value});
      terms.back().forces_end = forces.size();
    }



    void
    UnsymmetricTerms::add_motion(const unsigned int  block,
                                 const Tensor<1, 3> &value)
    {
      motions.push_back({block, value});
      terms.back().motions_end = motions.size();
    }



    void
    UnsymmetricTerms::add_product(const std::vector<Tensor<1, 3>> &motion,
                                  std::vector<Tensor<1, 3>> &all_forces) const
    {
      unsigned int f = 0, m = 0;
      for (const Term &term : terms)
        {
          double along = 0.;
          for (; m < term.motions_end; ++m)
            along += motions[m].value * motion[motions[m].block];
          for (; f < term.forces_end; ++f)
            if (forces[f].block < all_forces.size())
              all_forces[forces[f].block] += along * forces[f].value;
        }
    }
  } // namespace System
} // namespace Heddle
