// A rigid motion changes nothing in an element, and nothing else costs no
// energy.
#include "../eigenmodes.h"
#include "random_element.h"

using State = std::vector<Tensor<1, 3>>;



bool
is_position(const RandomElement &random, const unsigned int block)
{
  return block % random.element->n_blocks_per_node() == 0;
}



std::vector<double>
strains(const RandomElement &random, const State &state)
{
  std::vector<double> result(random.element->n_strains());
  random.element->strains(state.data(), random.length, result.data());
  return result;
}



Tensor<1, 3>
force(const std::vector<double> &residual, const unsigned int block)
{
  return Tensor<1, 3>(
    {residual[3 * block], residual[3 * block + 1], residual[3 * block + 2]});
}



/** A rotation about no axis of the coordinates. */
Tensor<2, 3>
some_rotation()
{
  const Tensor<1, 3> a = Tensor<1, 3>({2., -1., .5}) / std::sqrt(5.25);
  const Tensor<1, 3> b = Tensor<1, 3>({1., 2., 0.}) / std::sqrt(5.);
  const Tensor<1, 3> c = cross_product_3d(a, b);
  Tensor<2, 3>       rotation;
  for (unsigned int i = 0; i < 3; ++i)
    {
      rotation[0][i] = a[i];
      rotation[1][i] = b[i];
      rotation[2][i] = c[i];
    }
  return rotation;
}



/**
 * A rigid motion of a stressed element leaves strains, energy and section
 * forces as they are and turns the nodal forces; these have no resultant and no
 * moment. The split of the energy adds up to the energy. Only an element that
 * is turned back on itself is not aligned with its ends or sections.
 */
void
moved_elements()
{
  const Tensor<2, 3> rotation = some_rotation();
  const Tensor<1, 3> shift({3., -4., 5.});

  for (const Kind &kind : all_elements)
    {
      const RandomElement random(kind, /*seed=*/5);
      State               turned = random.blocks;
      for (unsigned int b = 0; b < turned.size(); ++b)
        turned[b] = rotation * random.blocks[b] +
                    (is_position(random, b) ? shift : Tensor<1, 3>());

      const auto before        = strains(random, random.blocks);
      const auto after         = strains(random, turned);
      double     strain_change = 0.;
      for (unsigned int i = 0; i < before.size(); ++i)
        strain_change = std::max(strain_change, std::abs(before[i] - after[i]));

      std::vector<double> residual, turned_residual;
      const double energy = random.assemble(random.blocks, &residual, nullptr);
      const double turned_energy =
        random.assemble(turned, &turned_residual, nullptr);

      double       force_change = 0.;
      Tensor<1, 3> resultant, moment;
      for (unsigned int b = 0; b < turned.size(); ++b)
        {
          const Tensor<1, 3> f = force(residual, b);
          force_change         = std::max(
            force_change, (rotation * f - force(turned_residual, b)).norm());
          moment += cross_product_3d(random.blocks[b], f);
          if (is_position(random, b))
            resultant += f;
        }

      const auto split =
        random.element->energy_split(random.section,
                                     random.blocks.data(),
                                     random.length,
                                     random.reference_strains.data());
      const double sum = split.axial + split.bending + split.shear +
                         split.torsion + split.section;

      deallog << kind.name << ' ' << kind.degree << ": energy "
              << rounded(energy, 4) << ", same energy "
              << (std::abs(energy - turned_energy) < 1e-13) << ", same strains "
              << (strain_change < 1e-13) << ", forces turn "
              << (force_change < 1e-13) << ", no resultant "
              << (resultant.norm() < 1e-13) << ", no moment "
              << (moment.norm() < 1e-13) << ", split adds up "
              << (std::abs(sum - energy) < 1e-13) << std::endl;

      const auto alignment = [&random](const State &state) {
        return random.element->alignment(state.data(), random.length);
      };
      const State straight = random.straight();
      State       back     = straight;
      for (unsigned int b = 0; b < back.size(); ++b)
        if (is_position(random, b))
          back[b][0] *= -1.;
      deallog << "  alignment at rest " << rounded(alignment(straight))
              << ", as before the motion "
              << (std::abs(alignment(turned) - alignment(random.blocks)) <
                  1e-13)
              << ", turned back " << (alignment(back) < 0.) << std::endl;
    }
}



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



/**
 * Only rigid motions cost no energy. The director elements have the six of a
 * body, from straight and from curved references. The Hermite element has the
 * five of a line without a spin about itself when it is straight; from a curved
 * reference nothing resists turning the plane of the curvature, and as many
 * modes cost energy as there are strains, that of a shared node counted once.
 */
void
zero_energy_modes()
{
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



int
main()
{
  initlog();
  run_part("Moved elements", moved_elements);
  run_part("Motions without energy", zero_energy_modes);
}
