#include <heddle/base/reduce.h>
#include <heddle/contributions/matrix_elasticity.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace Heddle
{
  namespace Contributions
  {
    namespace
    {
      constexpr unsigned int max_nodes = 27;

      /** An iteration changes no deformation gradient by more than this. */
      constexpr double largest_change = 0.3;
    } // namespace



    MatrixElasticity::MatrixElasticity(const System::MatrixSpace       &matrix,
                                       std::unique_ptr<Solid::Material> the_law,
                                       const bool mean_dilatation,
                                       const std::vector<double> &parts)
      : matrix(matrix)
      , law(std::move(the_law))
      , parts(parts)
      , shapes(
          std::make_unique<FEValues<3>>(matrix.shape_functions(),
                                        QGauss<3>(matrix.degree() + 1),
                                        update_gradients | update_JxW_values))
      , kernel(*law,
               matrix.n_nodes_per_cell(),
               shapes->n_quadrature_points,
               mean_dilatation)
      , stiffest(find_largest_stiffness())
    {
    }



    MatrixElasticity::~MatrixElasticity() = default;



    double
    MatrixElasticity::find_largest_stiffness() const
    {
      // M times the integral of |grad N|^2, M being the modulus of waves.
      double largest = 0.;
      for (const unsigned int c : matrix.near_cells())
        {
          shapes->reinit(Triangulation<3>::cell_iterator(
            &matrix.hexahedra(), /*level=*/0, static_cast<int>(c)));
          for (unsigned int a = 0; a < matrix.n_nodes_per_cell(); ++a)
            {
              double sum = 0.;
              for (const unsigned int q : shapes->quadrature_point_indices())
                sum += shapes->JxW(q) * shapes->shape_grad(a, q).norm_square();
              largest = std::max(largest, sum);
            }
        }
      return law->longitudinal_modulus() * largest;
    }



    void
    MatrixElasticity::visit(const System::State &state,
                            const unsigned int   c,
                            CellData            &data) const
    {
      const unsigned int n = matrix.n_nodes_per_cell();
      data.blocks.resize(n);
      data.places.resize(n);
      for (unsigned int a = 0; a < n; ++a)
        {
          data.blocks[a] = state.matrix_block(matrix.cell(c)[a]);
          data.places[a] = state.current()[data.blocks[a]];
        }

      shapes->reinit(Triangulation<3>::cell_iterator(
        &matrix.hexahedra(), /*level=*/0, static_cast<int>(c)));
      data.gradients.clear();
      data.weights.clear();
      for (const unsigned int q : shapes->quadrature_point_indices())
        {
          data.weights.push_back(parts[c] * shapes->JxW(q));
          for (unsigned int a = 0; a < n; ++a)
            {
              const Tensor<1, 3> &gradient = shapes->shape_grad(a, q);
              data.gradients.insert(
                data.gradients.end(), gradient.begin_raw(), gradient.end_raw());
            }
        }
    }



    void
    MatrixElasticity::add_pattern(const System::State  &state,
                                  System::BlockPattern &pattern)
    {
      if (law->is_linear() && !stiffness)
        assemble_once(state);
      if (stiffness)
        {
          stiffness->add_pattern(pattern);
          return;
        }
      const unsigned int                  n = matrix.n_nodes_per_cell();
      std::array<unsigned int, max_nodes> blocks;
      for (const unsigned int c : matrix.near_cells())
        {
          for (unsigned int a = 0; a < n; ++a)
            blocks[a] = state.matrix_block(matrix.cell(c)[a]);
          pattern.couple(n, blocks.data());
        }
    }



    void
    MatrixElasticity::assemble_once(const System::State &state)
    {
      const unsigned int n     = matrix.n_nodes_per_cell();
      const unsigned int first = state.n_owned_fiber_blocks();
      const unsigned int end   = state.n_owned_blocks();

      std::vector<std::set<unsigned int>> columns(end - first);
      CellData                            cell;
      for (const unsigned int c : matrix.near_cells())
        {
          visit(state, c, cell);
          for (const unsigned int row : cell.blocks)
            if (row < end)
              columns[row - first].insert(cell.blocks.begin(),
                                          cell.blocks.end());
        }
      std::vector<std::vector<unsigned int>> lists;
      for (const auto &row : columns)
        lists.emplace_back(row.begin(), row.end());
      stiffness = std::make_unique<ConstantStiffness>(first, lists);

      std::vector<double> residual(3 * n), tangent(9 * n * n);
      for (const unsigned int c : matrix.near_cells())
        {
          visit(state, c, cell);
          kernel.assemble(cell.gradients.data(),
                          cell.weights.data(),
                          cell.places.data(),
                          residual.data(),
                          tangent.data());
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int b = 0; b < n && cell.blocks[a] < end; ++b)
              {
                Tensor<2, 3> block;
                for (unsigned int d = 0; d < 3; ++d)
                  for (unsigned int e = 0; e < 3; ++e)
                    block[d][e] = tangent[(3 * a + d) * 3 * n + 3 * b + e];
                stiffness->add(cell.blocks[a], cell.blocks[b], block);
              }
        }
      ++assemblies;
    }



    void
    MatrixElasticity::assemble(const System::State &state,
                               System::BlockSystem &system)
    {
      if (law->is_linear())
        {
          if (!stiffness)
            assemble_once(state);
          const auto forces = stiffness->times([&state](const unsigned int b) {
            return state.current()[b] - state.matrix_reference(b);
          });
          for (unsigned int row = 0; row < forces.size(); ++row)
            system.add_force(stiffness->first_row() + row, forces[row]);
          if (system.wants_tangent())
            stiffness->add_to(system);
          return;
        }

      const unsigned int                n = matrix.n_nodes_per_cell();
      std::array<double, 3 * max_nodes> residual;
      std::vector<double>               tangent(9 * n * n);
      CellData                          cell;
      for (const unsigned int c : matrix.near_cells())
        {
          visit(state, c, cell);
          const double energy =
            kernel.assemble(cell.gradients.data(),
                            cell.weights.data(),
                            cell.places.data(),
                            residual.data(),
                            system.wants_tangent() ? tangent.data() : nullptr);
          // A cell that is inside out, by round-off at best, has no forces.
          if (!std::isfinite(energy))
            residual.fill(std::numeric_limits<double>::quiet_NaN());
          system.add(n, cell.blocks.data(), residual.data(), tangent.data());
        }
      assemblies += system.wants_tangent() ? 1 : 0;
    }



    double
    MatrixElasticity::largest_step(const System::State     &state,
                                   const System::Increment &increment) const
    {
      double largest = 0.;
      if (law->is_linear())
        return std::numeric_limits<double>::max();
      CellData cell;
      for (const unsigned int c : matrix.near_cells())
        {
          visit(state, c, cell);
          const unsigned int n = cell.blocks.size();
          for (unsigned int q = 0; q < cell.weights.size(); ++q)
            {
              // With the change in units of what there is det F stays positive.
              Tensor<2, 3> deformation, change;
              for (unsigned int a = 0; a < n; ++a)
                for (unsigned int d = 0; d < 3; ++d)
                  for (unsigned int e = 0; e < 3; ++e)
                    {
                      const double gradient =
                        cell.gradients[3 * (q * n + a) + e];
                      deformation[d][e] += cell.places[a][d] * gradient;
                      change[d][e] += increment[cell.blocks[a]][d] * gradient;
                    }
              largest =
                std::max(largest, (change * invert(deformation)).norm());
            }
        }
      return largest_change / largest;
    }



    std::vector<Solid::PointState>
    MatrixElasticity::evaluate(const System::State &state,
                               const unsigned int   c) const
    {
      CellData cell;
      visit(state, c, cell);
      std::vector<Solid::PointState> states(cell.weights.size());
      kernel.evaluate(cell.gradients.data(),
                      cell.weights.data(),
                      cell.places.data(),
                      states.data());
      return states;
    }



    MatrixElasticity::Turns
    MatrixElasticity::turns(const System::State &state,
                            const double         limit) const
    {
      Turns result;
      if (!law->is_linear())
        return result;
      struct
      {
        double all = 0., turned = 0.; /**< [mm^3] */
      } volumes;
      CellData cell;
      for (const unsigned int c : matrix.near_cells())
        if (matrix.owns(matrix.cell(c)[0]))
          {
            visit(state, c, cell);
            const unsigned int n = cell.blocks.size();
            for (unsigned int q = 0; q < cell.weights.size(); ++q)
              {
                Tensor<2, 3> F;
                for (unsigned int a = 0; a < n; ++a)
                  for (unsigned int J = 0; J < 3; ++J)
                    for (unsigned int i = 0; i < 3; ++i)
                      F[i][J] +=
                        cell.places[a][i] * cell.gradients[3 * (q * n + a) + J];
                // Exact for rotations; strains change it by a part of itself.
                const Tensor<1, 3> axis =
                  0.5 *
                  Tensor<1, 3>(
                    {F[2][1] - F[1][2], F[0][2] - F[2][0], F[1][0] - F[0][1]});
                const double angle =
                  std::atan2(axis.norm(), 0.5 * (trace(F) - 1.));
                result.largest = std::max(result.largest, angle);
                volumes.all += cell.weights[q];
                volumes.turned += angle > limit ? cell.weights[q] : 0.;
              }
          }
      sum_over_ranks(volumes, state.space.communicator());
      result.largest =
        Utilities::MPI::max(result.largest, state.space.communicator());
      result.part = volumes.turned / volumes.all;
      return result;
    }



    void
    MatrixElasticity::report(const System::State           &state,
                             std::map<std::string, double> &values) const
    {
      // Cells at the border of ranks count where their first node belongs.
      double   energy = 0.;
      CellData cell;
      for (const unsigned int c : matrix.near_cells())
        if (matrix.owns(matrix.cell(c)[0]))
          {
            visit(state, c, cell);
            energy += kernel.assemble(cell.gradients.data(),
                                      cell.weights.data(),
                                      cell.places.data(),
                                      nullptr,
                                      nullptr);
          }
      values["matrix_energy[N*mm]"] =
        Utilities::MPI::sum(energy, state.space.communicator());
    }
  } // namespace Contributions
} // namespace Heddle
