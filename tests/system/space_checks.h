#ifndef heddle_tests_system_space_checks_h
#define heddle_tests_system_space_checks_h

#include <deal.II/fe/fe.h>

#include "small_scene.h"

#include <algorithm>
#include <cmath>

/** Numbers of all ranks, the same on all of them. */
using OfRanks = std::vector<std::array<unsigned int, 4>>;

inline OfRanks
shares(const System::FiberSpace &space)
{
  const auto fibers = space.owned_fibers(), blocks = space.owned_blocks();
  return Utilities::MPI::all_gather(
    MPI_COMM_WORLD,
    std::array<unsigned int, 4>{
      {fibers.first, fibers.second, blocks.first, blocks.second}});
}



/** Whether each share begins where the one before ends, and nothing is left. */
inline bool
are_consecutive(const System::FiberSpace &space, const OfRanks &shares)
{
  bool         good = true;
  unsigned int end = 0, end_of_blocks = 0;
  for (unsigned int rank = 0; rank < shares.size(); ++rank)
    {
      const auto &share = shares[rank];
      good              = good && share[0] == end && share[2] == end_of_blocks;
      end               = share[1];
      for (unsigned int f = share[0]; f < share[1]; ++f)
        end_of_blocks += space.n_blocks(f);
      good = good && share[3] == end_of_blocks &&
             space.end_of_blocks(rank) == end_of_blocks;
    }
  return good && end == space.n_fibers() && end_of_blocks == space.n_blocks();
}



/** Whether no cut between ranks could be nearer to where shares are equal. */
inline bool
are_even(const System::FiberSpace &space, const OfRanks &shares)
{
  bool good = true;
  for (unsigned int rank = 1; rank < shares.size(); ++rank)
    {
      const double ideal = double(space.n_blocks()) * rank / shares.size();
      const double miss  = std::abs(shares[rank][2] - ideal);
      for (unsigned int f = 0; f < space.n_fibers(); ++f)
        good = good && miss <= std::abs(space.first_block(f) - ideal) + 1e-9;
      good = good && miss <= space.n_blocks() - ideal + 1e-9;
    }
  return good;
}



inline bool
are_owners(const System::FiberSpace &space, const OfRanks &shares)
{
  const unsigned int here = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  bool               good = true;
  for (unsigned int rank = 0; rank < shares.size(); ++rank)
    for (unsigned int f = shares[rank][0]; f < shares[rank][1]; ++f)
      good = good && space.owner(f) == rank && space.owns(f) == (rank == here);
  return good;
}



/** Whether ranks own nodes in a row, one rank each, and all agree. */
inline bool
are_nodes_owned(const System::MatrixSpace &matrix)
{
  const auto owned  = matrix.owned_nodes();
  const auto ranges = Utilities::MPI::all_gather(
    MPI_COMM_WORLD, std::array<unsigned int, 2>{{owned.first, owned.second}});
  const unsigned int here = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  unsigned int       end  = 0;
  bool               good = true;
  for (unsigned int rank = 0; rank < ranges.size(); ++rank)
    {
      good = good && ranges[rank][0] == end && matrix.first_node(rank) == end;
      end  = ranges[rank][1];
      for (unsigned int node = ranges[rank][0]; node < end; ++node)
        good = good && matrix.owner(node) == rank &&
               matrix.owns(node) == (rank == here);
    }
  return good && end == matrix.n_nodes();
}



/** Whether the nodes of all cells lie where the mesh has them. */
inline bool
are_in_place(const System::MatrixSpace    &matrix,
             const System::HexahedralMesh &mesh)
{
  const auto &points = matrix.shape_functions().get_unit_support_points();
  bool        good   = matrix.n_cells() == mesh.cells.size();
  for (unsigned int c = 0; c < mesh.cells.size(); ++c)
    for (unsigned int a = 0; a < points.size(); ++a)
      {
        Tensor<1, 3> place;
        for (unsigned int v = 0; v < 8; ++v)
          place += GeometryInfo<3>::d_linear_shape_function(points[a], v) *
                   mesh.vertices[mesh.cells[c][v]];
        good =
          good && (matrix.reference(matrix.cell(c)[a]) - place).norm() < 1e-12;
      }
  return good;
}



/** Whether these are the cells with own nodes. */
inline bool
are_near(const System::MatrixSpace &matrix)
{
  std::vector<unsigned int> expected;
  for (unsigned int c = 0; c < matrix.n_cells(); ++c)
    if (std::any_of(matrix.cell(c),
                    matrix.cell(c) + matrix.n_nodes_per_cell(),
                    [&](const unsigned int node) { return matrix.owns(node); }))
      expected.push_back(c);
  return matrix.near_cells() == expected;
}



/** Whether sides have the nodes on the faces that the mesh has there. */
inline bool
are_on_sides(const System::MatrixSpace    &matrix,
             const System::HexahedralMesh &mesh)
{
  const auto &points = matrix.shape_functions().get_unit_support_points();
  bool        good   = true;
  for (unsigned int side = 0; side < 6; ++side)
    {
      std::set<unsigned int> nodes;
      for (unsigned int c = 0; c < mesh.cells.size(); ++c)
        {
          std::array<unsigned int, 4> vertices;
          for (unsigned int v = 0; v < 4; ++v)
            vertices[v] =
              mesh.cells[c][GeometryInfo<3>::face_to_cell_vertices(side, v)];
          for (const auto &face : mesh.faces)
            if (face.side == side && face.vertices == vertices)
              for (unsigned int a = 0; a < points.size(); ++a)
                if (points[a][side / 2] == side % 2)
                  nodes.insert(matrix.cell(c)[a]);
        }
      good = good && matrix.nodes_on_side(side) ==
                       std::vector<unsigned int>(nodes.begin(), nodes.end());
    }
  return good;
}



/** A number that differs where nodes change their identities. */
inline double
checksum(const System::MatrixSpace &matrix)
{
  std::set<unsigned int> met;
  double                 sum = 0.;
  for (unsigned int node = 0; node < matrix.n_nodes(); ++node)
    {
      const Point<3> &x = matrix.reference(node);
      met.insert(matrix.identity(node));
      sum += matrix.identity(node) * (x[0] + 7. * x[1] + 31. * x[2]);
    }
  const bool all =
    met.size() == matrix.n_nodes() && *met.rbegin() + 1 == met.size();
  return all ? sum / (matrix.n_nodes() * matrix.n_nodes()) : -1.;
}

#endif
