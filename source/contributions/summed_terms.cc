#include <heddle/contributions/summed_terms.h>

#include <algorithm>

namespace Heddle
{
  namespace Contributions
  {
    SummedTerms::SummedTerms(System::BlockSystem &system)
      : system(system)
    {
    }



    void
    SummedTerms::begin(const unsigned int n, const unsigned int *new_blocks)
    {
      if (n == blocks.size() &&
          std::equal(blocks.begin(), blocks.end(), new_blocks))
        return;
      end();
      blocks.assign(new_blocks, new_blocks + n);
      residual_sum.assign(3 * n, 0.);
      if (system.wants_tangent())
        tangent_sum.assign(9 * n * n, 0.);
    }



    void
    SummedTerms::end()
    {
      if (!blocks.empty())
        system.add(blocks.size(),
                   blocks.data(),
                   residual_sum.data(),
                   tangent_sum.data());
      blocks.clear();
    }
  } // namespace Contributions
} // namespace Heddle
