#ifndef heddle_solver_terms_h
#define heddle_solver_terms_h

#include <heddle/system/nonsmooth_contribution.h>

#include <memory>
#include <vector>

namespace Heddle
{
  namespace Solver
  {
    /** The contributions of a scene, in the order of assembly. */
    using Contributions = std::vector<std::shared_ptr<System::Contribution>>;

    /** Those of them that are not smooth, in the same order. */
    using NonsmoothTerms = std::vector<System::NonsmoothContribution *>;

    NonsmoothTerms
    nonsmooth_terms(const Contributions &contributions);

    /** Whether any of them is not smooth as things are. */
    bool
    is_nonsmooth(const NonsmoothTerms &terms);
  } // namespace Solver
} // namespace Heddle

#endif
