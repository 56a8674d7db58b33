// Only rigid motions cost no energy. The director elements have the six of a
// body, from straight and from curved references. The Hermite element has the
// five of a line without a spin about itself when it is straight; from a curved
// reference nothing resists turning the plane of the curvature, and as many
// modes cost energy as there are strains, that of a shared node counted once.
#include "../eigenmodes.h"
#include "random_element.h"

using State = std::vector<Tensor<1, 3>>;

/** Blocks at s of a fiber of curvature @p kappa in the plane of x and y. */
void
add_node(const double s, const double kappa, const bool sections, State &blocks)
{
  const double       angle = kappa * s;
  const Tensor<1, 3> tangent({std::cos(angle), std::sin(angle), 0.});
  const Tensor<1, 3> normal({-std::sin(angle), std::cos(angle), 0.});
  const Tensor<1, 3> position(
    {kappa == 0. ? s : std::sin(angle) / kappa,
     kappa == 0. ? 0. : (1. - std::cos(angle)) / kappa,
     0.});
  blocks.push_back(position);
  if (sections)
    {
      blocks.push_back(normal);
      blocks.push_back(Tensor<1, 3>({0., 0., 1.}));
    }
  else
    blocks.push_back(tangent);
}



/** Eigenvalues of the tangent of a fiber of elements, smallest first. */
Vector<double>
eigenvalues(const Kind               &kind,
            const std::vector<double> lengths,
            const double              kappa)
{
  RandomElement      one(kind, /*seed=*/1);
  const auto        &element   = *one.element;
  const unsigned int per_node  = element.n_blocks_per_node();
  const unsigned int intervals = element.n_nodes() - 1;
  const unsigned int n         = one.n_unknowns();
  const unsigned int n_fiber = 3 * per_node * (intervals * lengths.size() + 1);

  LAPACKFullMatrix<double> matrix(n_fiber);
  double                   start = 0.;
  unsigned int             first = 0;
  for (const double length : lengths)
    {
      State blocks;
      for (unsigned int a = 0; a <= intervals; ++a)
        add_node(start + a * length / intervals, kappa, per_node == 3, blocks);
      std::vector<double> strains(element.n_strains()), tangent(n * n);
      element.strains(blocks.data(), length, strains.data());
      element.assemble(one.section,
                       blocks.data(),
                       length,
                       strains.data(),
                       /*predicted_stresses=*/nullptr,
                       /*residual=*/nullptr,
                       tangent.data());
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          matrix(first + i, first + j) += tangent[i * n + j];
      start += length;
      first += 3 * per_node * intervals;
    }
  return eigenmodes(matrix).first;
}



int
main()
{
  initlog();
  for (const Kind &kind : all_elements)
    for (const double kappa : {0., .3})
      for (const auto &lengths :
           {std::vector<double>{1.}, std::vector<double>{1., .6}})
        {
          const Vector<double> values = eigenvalues(kind, lengths, kappa);
          const double         large  = values(values.size() - 1);
          unsigned int         zero   = 0;
          while (values(zero) < 1e-12 * large)
            ++zero;
          deallog << kind.name << ' ' << kind.degree << ", curvature " << kappa
                  << ", elements " << lengths.size() << ", unknowns "
                  << values.size() << ": without energy " << zero
                  << ", negative " << (values(0) < -1e-12 * large)
                  << ", clear gap " << (values(zero) > 1e-6 * large)
                  << std::endl;
        }
}
