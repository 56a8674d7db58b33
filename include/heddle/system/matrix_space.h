#ifndef heddle_system_matrix_space_h
#define heddle_system_matrix_space_h

#include <deal.II/base/point.h>

#include <mpi.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

// Nearly all sources see this file, and few of them the mesh: its headers take
// seconds to compile.
namespace dealii
{
  template <int dim, int spacedim>
  class FiniteElement;
  template <int dim, int spacedim>
  class Triangulation;
} // namespace dealii

namespace Heddle
{
  namespace System
  {
    using namespace dealii;

    /** Hexahedra of the matrix, the same on all ranks. */
    struct HexahedralMesh
    {
      /** A face on the surface, by its vertices, and the side it lies on. */
      struct Face
      {
        std::array<unsigned int, 4> vertices;
        unsigned int                side;
      };

      std::vector<Point<3>> vertices; /**< [mm] */

      /** Eight vertices each, in the order of deal.II. */
      std::vector<std::array<unsigned int, 8>> cells;

      /** Faces of the surface, all of them: others would be on side 0. */
      std::vector<Face> faces;

      /** The rank that each cell goes to. */
      std::vector<unsigned int> ranks;
    };

    /**
     * The discrete matrix: hexahedra of degree 1 or 2 with one block of three
     * unknowns, a position, in each node.
     *
     * Every rank knows the topology of the whole mesh, and owns a consecutive
     * range of nodes. Cells keep the numbers that the mesh gave them.
     */
    class MatrixSpace
    {
    public:
      MatrixSpace(const MPI_Comm        communicator,
                  const HexahedralMesh &mesh,
                  const unsigned int    degree);

      ~MatrixSpace();

      MPI_Comm
      communicator() const
      {
        return mpi_communicator;
      }

      unsigned int
      degree() const
      {
        return polynomial_degree;
      }

      unsigned int
      n_cells() const
      {
        return cell_nodes.size() / n_nodes_per_cell();
      }

      /** Over all ranks. */
      unsigned int
      n_nodes() const
      {
        return rank_begin.back();
      }

      /** 8 or 27. */
      unsigned int
      n_nodes_per_cell() const
      {
        return (degree() + 1) * (degree() + 1) * (degree() + 1);
      }

      /**
       * Global numbers of the nodes of cell @p c, in the order of the shape
       * functions of FE_Q of this degree.
       */
      const unsigned int *
      cell(const unsigned int c) const
      {
        return cell_nodes.data() + c * n_nodes_per_cell();
      }

      /** Nodes [first, second) belong to this rank. */
      std::pair<unsigned int, unsigned int>
      owned_nodes() const
      {
        return {rank_begin[this_rank], rank_begin[this_rank + 1]};
      }

      bool
      owns(const unsigned int node) const
      {
        return node >= rank_begin[this_rank] &&
               node < rank_begin[this_rank + 1];
      }

      unsigned int
      owner(const unsigned int node) const;

      /** First node of @p rank. */
      unsigned int
      first_node(const unsigned int rank) const
      {
        return rank_begin[rank];
      }

      /** Cells that have a node of this rank, in ascending order. */
      const std::vector<unsigned int> &
      near_cells() const
      {
        return cells_with_owned_nodes;
      }

      /** Where node @p node lies in the reference configuration [mm]. */
      const Point<3> &
      reference(const unsigned int node) const
      {
        return references[node];
      }

      /** A number of the node that does not depend on the ranks. */
      unsigned int
      identity(const unsigned int node) const
      {
        return identities[node];
      }

      /** Nodes on a side of the matrix, on all ranks, in ascending order. */
      std::vector<unsigned int>
      nodes_on_side(const unsigned int side) const;

      /** Shape functions of one component. */
      const FiniteElement<3, 3> &
      shape_functions() const;

      /** The hexahedra: active cells, in the order of their numbers. */
      const Triangulation<3, 3> &
      hexahedra() const;

    private:
      /** What deal.II knows of the mesh. */
      struct Discretisation;

      void
      number_nodes();

      const MPI_Comm                        mpi_communicator;
      const unsigned int                    polynomial_degree;
      const unsigned int                    this_rank;
      const std::unique_ptr<Discretisation> discretisation;
      std::vector<unsigned int>             rank_begin;
      std::vector<unsigned int>             cell_nodes;
      std::vector<unsigned int>             identities;
      std::vector<Point<3>>                 references;
      std::vector<unsigned int>             cells_with_owned_nodes;
    };
  } // namespace System
} // namespace Heddle

#endif
