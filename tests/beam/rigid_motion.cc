// A rigid motion of a stressed element leaves strains, energy and section
// forces as they are and turns the nodal forces; these have no resultant and no
// moment. The split of the energy adds up to the energy. Only an element that
// is turned back on itself is not aligned with its ends or sections.
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



int
main()
{
  initlog();
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
