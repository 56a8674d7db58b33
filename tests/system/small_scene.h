#ifndef heddle_tests_system_small_scene_h
#define heddle_tests_system_small_scene_h

#include <heddle/base/choice.h>
#include <heddle/system/state.h>

#include <deal.II/base/geometry_info.h>

#include "../tests.h"

#include <memory>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace Heddle;

using Vectors = std::vector<Tensor<1, 3>>;
using Pieces  = std::vector<System::GhostFiber>;

/** Whether this is so on all ranks. */
inline bool
everywhere(const bool here)
{
  return Utilities::MPI::min(here ? 1 : 0, MPI_COMM_WORLD) == 1;
}



/** Fibers with so many elements each. */
inline std::unique_ptr<System::FiberSpace>
make_space(const std::string               &element,
           const unsigned int               degree,
           const std::vector<unsigned int> &n_elements)
{
  std::vector<System::FiberSpace::Description> fibers;
  for (const unsigned int n : n_elements)
    {
      fibers.emplace_back();
      fibers.back().element_lengths.assign(n, 0.5);
      fibers.back().radius  = 0.1;
      fibers.back().section = Beam::circular_section(/*radius=*/0.1,
                                                     /*axial_modulus=*/100.,
                                                     /*shear_modulus=*/40.,
                                                     /*poisson_ratio=*/0.25);
    }
  return std::make_unique<System::FiberSpace>(
    MPI_COMM_WORLD,
    Beam::make_element(choice<Beam::ElementKind>(element), degree),
    fibers);
}



/**
 * A layer of @p n_x times @p n_y cells, all with a side of its own in the order
 * of the faces of a hexahedron. They go to the ranks by turns, the first one to
 * the last rank.
 */
inline System::HexahedralMesh
layer_of_cells(const unsigned int n_x, const unsigned int n_y)
{
  System::HexahedralMesh mesh;
  const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  for (unsigned int k = 0; k < 2; ++k)
    for (unsigned int j = 0; j <= n_y; ++j)
      for (unsigned int i = 0; i <= n_x; ++i)
        mesh.vertices.emplace_back(i + 0.1 * j * k, j + 0.2 * i * i, k);
  const std::array<unsigned int, 3> n = {{n_x, n_y, 1}};
  for (unsigned int j = 0; j < n_y; ++j)
    for (unsigned int i = 0; i < n_x; ++i)
      {
        mesh.ranks.push_back(n_ranks - 1 - mesh.cells.size() % n_ranks);
        mesh.cells.emplace_back();
        auto &cell = mesh.cells.back();
        for (unsigned int v = 0; v < 8; ++v)
          cell[v] = i + v % 2 + (n_x + 1) * (j + v / 2 % 2) +
                    (n_x + 1) * (n_y + 1) * (v / 4);
        const std::array<unsigned int, 3> place = {{i, j, 0}};
        for (unsigned int side = 0; side < 6; ++side)
          if (place[side / 2] == (side % 2 == 0 ? 0 : n[side / 2] - 1))
            {
              mesh.faces.emplace_back();
              mesh.faces.back().side = side;
              for (unsigned int v = 0; v < 4; ++v)
                mesh.faces.back().vertices[v] =
                  cell[GeometryInfo<3>::face_to_cell_vertices(side, v)];
            }
      }
  return mesh;
}



/** Nodes of other ranks in the cells that have one of this rank. */
inline std::vector<unsigned int>
foreign_nodes(const System::MatrixSpace &matrix)
{
  std::set<unsigned int> nodes;
  for (const unsigned int c : matrix.near_cells())
    for (unsigned int a = 0; a < matrix.n_nodes_per_cell(); ++a)
      if (!matrix.owns(matrix.cell(c)[a]))
        nodes.insert(matrix.cell(c)[a]);
  return {nodes.begin(), nodes.end()};
}



/** Number of the block of fiber or matrix, whatever the ranks are. */
inline unsigned int
identity_of_block(const System::FiberSpace &space,
                  const unsigned int        f,
                  const unsigned int        b)
{
  return space.first_block(f) + b;
}

inline unsigned int
identity_of_node(const System::State &state, const unsigned int node)
{
  return state.space.n_blocks() + state.matrix()->identity(node);
}



/**
 * These numbers of all local blocks. Of those that no fiber and no node has, or
 * that two have, it is invalid.
 */
inline std::vector<unsigned int>
identities(const System::State &state)
{
  constexpr unsigned int    invalid = numbers::invalid_unsigned_int;
  const System::FiberSpace &space   = state.space;
  std::vector<unsigned int> result(state.n_local_blocks(), invalid);
  std::set<unsigned int>    met;
  const auto enter = [&](const unsigned int block, const unsigned int number) {
    result[block] = met.insert(block).second ? number : invalid;
  };
  for (unsigned int f = 0; f < space.n_fibers(); ++f)
    for (unsigned int b = 0; b < space.n_blocks(f); ++b)
      if (state.has(f, b))
        enter(state.local_block(f) + int(b), identity_of_block(space, f, b));
  if (state.matrix())
    for (unsigned int node = 0; node < state.matrix()->n_nodes(); ++node)
      if (state.has_matrix_node(node))
        enter(state.matrix_block(node), identity_of_node(state, node));
  return result;
}

#endif
