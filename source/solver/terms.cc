#include <heddle/solver/terms.h>

#include <algorithm>

namespace Heddle
{
  namespace Solver
  {
    NonsmoothTerms
    nonsmooth_terms(const Contributions &contributions)
    {
      NonsmoothTerms terms;
      for (const auto &contribution : contributions)
        if (auto *const term =
              dynamic_cast<System::NonsmoothContribution *>(contribution.get()))
          terms.push_back(term);
      return terms;
    }



    bool
    is_nonsmooth(const NonsmoothTerms &terms)
    {
      return std::any_of(terms.begin(), terms.end(), [](const auto *term) {
        return term->is_nonsmooth();
      });
    }
  } // namespace Solver
} // namespace Heddle
