#ifndef heddle_tests_coupling_assemble_link_h
#define heddle_tests_coupling_assemble_link_h

#include "../tests.h"

#include <vector>

using Vectors = std::vector<Tensor<1, 3>>;

/** The energy of a link with blocks @p at; write its gradient to @p forces. */
template <class Link>
double
assemble_link(const Link          &link,
              const Vectors       &at,
              Vectors             &forces,
              std::vector<double> *tangent)
{
  // What is not written, or added to what is there, is seen.
  std::vector<double> residual(3 * link.n, 7.);
  if (tangent != nullptr)
    tangent->assign(9 * link.n * link.n, 7.);
  const double energy = link.assemble(
    at.data(), residual.data(), tangent != nullptr ? tangent->data() : nullptr);
  forces.resize(link.n);
  for (unsigned int i = 0; i < residual.size(); ++i)
    forces[i / 3][i % 3] = residual[i];
  return energy;
}

#endif
