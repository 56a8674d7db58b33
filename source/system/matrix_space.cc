#include <heddle/system/matrix_space.h>

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/shared_tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>

#include <algorithm>
#include <set>

namespace Heddle
{
  namespace System
  {
    namespace
    {
      std::vector<CellData<3>>
      cells_of(const HexahedralMesh &mesh)
      {
        std::vector<CellData<3>> cells;
        cells.reserve(mesh.cells.size());
        for (const auto &vertices : mesh.cells)
          {
            cells.emplace_back();
            cells.back().vertices.assign(vertices.begin(), vertices.end());
          }
        return cells;
      }



      SubCellData
      sides_of(const HexahedralMesh &mesh)
      {
        SubCellData sides;
        for (const HexahedralMesh::Face &face : mesh.faces)
          {
            sides.boundary_quads.emplace_back();
            sides.boundary_quads.back().vertices.assign(face.vertices.begin(),
                                                        face.vertices.end());
            sides.boundary_quads.back().boundary_id = face.side;
          }
        return sides;
      }
    } // namespace



    struct MatrixSpace::Discretisation
    {
      Discretisation(const MPI_Comm communicator, const unsigned int degree)
        : triangulation(
            communicator,
            Triangulation<3>::none,
            /*allow_artificial_cells=*/false,
            parallel::shared::Triangulation<3>::partition_custom_signal)
        , element(FE_Q<3>(degree), 3)
        , dof_handler(triangulation)
      {
      }

      parallel::shared::Triangulation<3> triangulation;
      const FESystem<3>                  element;
      DoFHandler<3>                      dof_handler;
    };



    MatrixSpace::MatrixSpace(const MPI_Comm        communicator,
                             const HexahedralMesh &mesh,
                             const unsigned int    degree)
      : mpi_communicator(communicator)
      , polynomial_degree(degree)
      , this_rank(Utilities::MPI::this_mpi_process(communicator))
      , discretisation(std::make_unique<Discretisation>(communicator, degree))
    {
      auto &triangulation = discretisation->triangulation;
      triangulation.signals.create.connect([&]() {
        for (const auto &cell : triangulation.active_cell_iterators())
          cell->set_subdomain_id(mesh.ranks[cell->active_cell_index()]);
      });
      triangulation.create_triangulation(
        mesh.vertices, cells_of(mesh), sides_of(mesh));
      discretisation->dof_handler.distribute_dofs(discretisation->element);
      number_nodes();
    }



    MatrixSpace::~MatrixSpace() = default;



    const FiniteElement<3, 3> &
    MatrixSpace::shape_functions() const
    {
      return discretisation->element.base_element(0);
    }



    const Triangulation<3, 3> &
    MatrixSpace::hexahedra() const
    {
      return discretisation->triangulation;
    }



    void
    MatrixSpace::number_nodes()
    {
      const FESystem<3>   &element     = discretisation->element;
      const DoFHandler<3> &dof_handler = discretisation->dof_handler;

      // The three unknowns of a node are numbered in a row on one rank, so that
      // a node is a third of its first unknown.
      Assert(dof_handler.locally_owned_dofs().is_contiguous() ||
               dof_handler.n_locally_owned_dofs() == 0,
             ExcInternalError());
      rank_begin.assign(1, 0);
      for (const auto n : Utilities::MPI::all_gather(
             mpi_communicator, dof_handler.n_locally_owned_dofs()))
        rank_begin.push_back(rank_begin.back() + n / 3);

      const unsigned int n_per_cell = n_nodes_per_cell();
      FEValues<3>        mapped(
        shape_functions(),
        Quadrature<3>(shape_functions().get_unit_support_points()),
        update_quadrature_points);
      std::vector<types::global_dof_index> indices(element.n_dofs_per_cell());
      identities.assign(n_nodes(), numbers::invalid_unsigned_int);
      references.resize(n_nodes());
      unsigned int n_met = 0;
      for (const auto &cell : dof_handler.active_cell_iterators())
        {
          cell->get_dof_indices(indices);
          mapped.reinit(
            static_cast<const Triangulation<3>::cell_iterator &>(cell));
          bool near = false;
          for (unsigned int a = 0; a < n_per_cell; ++a)
            {
              const auto first =
                indices[element.component_to_system_index(0, a)];
              const unsigned int node = first / 3;
              for (unsigned int d = 0; d < 3; ++d)
                AssertDimension(
                  indices[element.component_to_system_index(d, a)],
                  3 * node + d);
              cell_nodes.push_back(node);
              near             = near || owns(node);
              references[node] = mapped.quadrature_point(a);
              if (identities[node] == numbers::invalid_unsigned_int)
                identities[node] = n_met++;
            }
          if (near)
            cells_with_owned_nodes.push_back(cell->active_cell_index());
        }
    }



    unsigned int
    MatrixSpace::owner(const unsigned int node) const
    {
      return std::upper_bound(rank_begin.begin(), rank_begin.end(), node) -
             rank_begin.begin() - 1;
    }



    std::vector<unsigned int>
    MatrixSpace::nodes_on_side(const unsigned int side) const
    {
      std::set<unsigned int> nodes;
      for (const auto &cell :
           discretisation->triangulation.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              cell->face(f)->boundary_id() == side)
            for (unsigned int a = 0; a < n_nodes_per_cell(); ++a)
              if (shape_functions().has_support_on_face(a, f))
                nodes.insert(this->cell(cell->active_cell_index())[a]);
      return {nodes.begin(), nodes.end()};
    }
  } // namespace System
} // namespace Heddle
