#ifndef heddle_tests_system_composite_h
#define heddle_tests_system_composite_h

#include "random_terms.h"

/**
 * Fibers in a matrix; each rank has copies of all that is not its own. There is
 * one fiber of director elements: the first of three ranks has nothing then.
 */
class Composite
{
public:
  Composite(const std::string &element)
    : space(element == "hermite" ? make_space(element, 3, {2, 3, 1, 4})
                                 : make_space(element, 1, {9}))
    , matrix(MPI_COMM_WORLD, layer_of_cells(2, 1), /*degree=*/1)
    , state(*space)
    , terms(space->n_blocks() + matrix.n_nodes())
  {
    Pieces foreign;
    for (unsigned int f = 0; f < space->n_fibers(); ++f)
      if (!space->owns(f))
        foreign.push_back({f, space->all_nodes(f)});
    std::vector<unsigned int> nodes;
    for (unsigned int node = 0; node < matrix.n_nodes(); ++node)
      if (!matrix.owns(node))
        nodes.push_back(node);
    state.set_matrix(&matrix, nodes, foreign);
    of_local = identities(state);
    local.resize(of_local.size());
    for (unsigned int b = 0; b < local.size(); ++b)
      local[of_local[b]] = b;
  }

  Blocks
  local_blocks(const Blocks &blocks) const
  {
    Blocks result;
    for (const unsigned int block : blocks)
      result.push_back(local[block]);
    return result;
  }

  /** Whether any of these blocks is owned. */
  bool
  has_part_in(const Blocks &blocks) const
  {
    return std::any_of(blocks.begin(), blocks.end(), [&](const unsigned int b) {
      return local[b] < state.n_owned_blocks();
    });
  }

  /**
   * What stands in the rows of prescribed components: E A / h of positions, E A
   * h of other blocks of a fiber with elements of length h, 1 of the matrix.
   */
  double
  held_stiffness(const unsigned int block) const
  {
    if (block >= space->n_blocks())
      return 1.;
    const double h = 0.5, axial = space->fiber(0).section.axial;
    return block % space->n_blocks_per_node() == 0 ? axial / h : axial * h;
  }

  const std::unique_ptr<System::FiberSpace> space;
  const System::MatrixSpace                 matrix;
  System::State                             state;
  RandomTerms                               terms;
  Blocks                                    of_local; /**< their identities */
  Blocks                                    local;    /**< the other way */
};



/** Couplings have a place in the matrix unless they are kept apart. */
inline void
set_pattern(const Composite &scene, System::BlockSystem &system)
{
  const bool           apart = system.keeps_couplings_apart();
  System::BlockPattern pattern(scene.state.n_owned_blocks(), apart);
  const auto           couple = [&](const Blocks &blocks) {
    pattern.couple(blocks.size(), scene.local_blocks(blocks).data());
  };
  for (const auto &element : scene.terms.elements)
    couple(element.blocks);
  const Blocks row_blocks = scene.local_blocks(scene.terms.rows.blocks);
  for (const unsigned int row : row_blocks)
    if (row < scene.state.n_owned_blocks())
      pattern.add_row(row, row_blocks.size(), row_blocks.data());
  for (const auto *pairs : {&scene.terms.axes, &scene.terms.sections})
    for (const auto &pair : *pairs)
      if (!apart)
        couple(pair.blocks);
  system.set_pattern(pattern);
}



inline void
add(const Composite            &scene,
    const RandomTerms::Element &element,
    System::BlockSystem        &to)
{
  if (scene.has_part_in(element.blocks))
    to.add(element.blocks.size(),
           scene.local_blocks(element.blocks).data(),
           element.residual.data(),
           element.tangent.data());
}



template <unsigned int n_of_side>
void
add_pairs(const Composite                      &scene,
          const std::vector<RandomTerms::Pair> &pairs,
          System::PairCouplings<n_of_side>     &couplings,
          System::BlockSystem                  &system)
{
  for (const RandomTerms::Pair &pair : pairs)
    if (!system.keeps_couplings_apart())
      add(scene, RandomTerms::element_of(pair), system);
    else if (scene.has_part_in(pair.blocks))
      {
        typename System::PairCouplings<n_of_side>::Blocks blocks;
        typename System::PairCouplings<n_of_side>::Term   term;
        const Blocks local = scene.local_blocks(pair.blocks);
        std::copy(local.begin(), local.end(), blocks.begin());
        std::copy(
          pair.weights.begin(), pair.weights.end(), term.weights.begin());
        term.stiffness = pair.stiffness;
        couplings.add_term(blocks, term);
      }
}



/** The rows of a constant stiffness and the diagonal. */
inline void
add_rows(const Composite &scene, System::BlockSystem &system)
{
  const RandomTerms::Element &rows  = scene.terms.rows;
  const Blocks                local = scene.local_blocks(rows.blocks);
  const unsigned int          n     = local.size();
  for (unsigned int i = 0; i < n; ++i)
    if (local[i] < scene.state.n_owned_blocks())
      {
        std::vector<Tensor<2, 3>> values(n);
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int d = 0; d < 3; ++d)
            for (unsigned int e = 0; e < 3; ++e)
              values[j][d][e] = rows.tangent[(3 * i + d) * 3 * n + 3 * j + e];
        system.add_row(local[i], n, local.data(), values.data());
      }
  for (unsigned int b = 0; b < scene.state.n_owned_blocks(); ++b)
    system.add_diagonal(b, scene.terms.diagonal[scene.of_local[b]]);
}



inline void
add_unsymmetric(const Composite &scene, System::UnsymmetricTerms &to)
{
  for (unsigned int k = 0; k < scene.terms.motions.size(); ++k)
    {
      const auto &motion = scene.terms.motions[k];
      to.begin_term(motion.vector);
      for (unsigned int j = 0; j < motion.blocks.size(); ++j)
        to.add_motion(scene.local[motion.blocks[j]], motion.weights[j]);
      for (const auto &load : scene.terms.loads[k])
        {
          to.begin_force(load.vector);
          for (unsigned int i = 0; i < load.blocks.size(); ++i)
            to.add_force(scene.local[load.blocks[i]], load.weights[i]);
        }
    }
}



inline void
assemble(const Composite                &scene,
         const System::BlockSystem::Want want,
         System::BlockSystem            &system)
{
  system.begin(want);
  for (const auto &element : scene.terms.elements)
    add(scene, element, system);
  if (system.wants_tangent())
    {
      add_pairs(scene, scene.terms.axes, system.axis_couplings(), system);
      add_pairs(
        scene, scene.terms.sections, system.section_couplings(), system);
      add_rows(scene, system);
      add_unsymmetric(scene, system.unsymmetric_terms());
    }
  system.end();
}



/** Pairs of blocks that the terms in the matrix couple, each once. */
inline unsigned int
n_coupled_pairs(const Composite &scene, const System::BlockSystem &system)
{
  const RandomTerms                              &terms = scene.terms;
  std::set<std::pair<unsigned int, unsigned int>> pairs;
  const auto couple = [&](const Blocks &blocks) {
    for (const unsigned int i : blocks)
      for (const unsigned int j : blocks)
        pairs.emplace(std::min(i, j), std::max(i, j));
  };
  for (unsigned int b = 0; b < scene.local.size(); ++b)
    couple({b});
  for (const auto &element : terms.elements)
    couple(element.blocks);
  couple(terms.rows.blocks);
  for (const auto *coupled : {&terms.axes, &terms.sections})
    for (const auto &pair : *coupled)
      if (!system.keeps_couplings_apart())
        couple(pair.blocks);
  return pairs.size();
}

#endif
