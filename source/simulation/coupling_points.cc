#include <heddle/simulation/coupling_points.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe.h>

#include <algorithm>
#include <cmath>

namespace Heddle
{
  namespace Simulation
  {
    namespace
    {
      /** Of a piece that leaves the matrix: what it passes on as force and as
       * moment is exact where the matrix follows it linearly. */
      constexpr unsigned int n_points_at_surface = 2;

      /** Halvings by which the surface is found: to the last digits. */
      constexpr unsigned int n_halvings = 40;

      /** Shorter parts of an interval within the matrix are none. */
      constexpr double least_part_within = 1e-6;
    } // namespace



    CouplingPoints::CouplingPoints(const System::State       &state,
                                   const Textile::MatrixMesh &mesh,
                                   const System::MatrixSpace &matrix,
                                   const bool                 with_sections)
      : state(state)
      , mesh(mesh)
      , matrix(matrix)
      , with_sections(with_sections && state.space.n_blocks_per_node() == 3)
    {
    }



    void
    CouplingPoints::add_nodes(const unsigned int fiber)
    {
      const System::FiberSpace &space = state.space;
      const double             *s     = space.node_positions(fiber);
      const unsigned int        n     = space.fiber(fiber).n_nodes;
      std::vector<bool>         within(n);
      for (unsigned int i = 0; i < n; ++i)
        within[i] = contains(fiber, s[i]);

      for (unsigned int i = 0; i < n; ++i)
        {
          double length = 0.;
          if (i > 0 && within[i - 1])
            length += 0.5 * (s[i] - s[i - 1]);
          if (i + 1 < n && within[i + 1])
            length += 0.5 * (s[i + 1] - s[i]);
          if (within[i] && length > 0.)
            add(
              fiber,
              s[i],
              {{{i * space.n_blocks_per_node(), 0, 0, 0}}, {{1., 0., 0., 0.}}},
              length);

          if (i + 1 < n && within[i] != within[i + 1])
            {
              const double inside  = within[i] ? s[i] : s[i + 1];
              const double outside = within[i] ? s[i + 1] : s[i];
              const double surface = surface_between(fiber, inside, outside);
              if (std::abs(surface - inside) >
                  least_part_within * std::abs(outside - inside))
                add_piece(fiber,
                          n_points_at_surface,
                          std::min(inside, surface),
                          std::max(inside, surface));
            }
        }
    }



    void
    CouplingPoints::add_gauss_points(const unsigned int fiber,
                                     const unsigned int n)
    {
      const System::FiberSpace &space = state.space;
      for (unsigned int e = 0; e < space.fiber(fiber).n_elements; ++e)
        {
          const double begin =
            space.node_positions(fiber)[e * (space.element().n_nodes() - 1)];
          add_piece(fiber, n, begin, begin + space.element_length(fiber, e));
        }
    }



    bool
    CouplingPoints::contains(const unsigned int fiber, const double s) const
    {
      const Tensor<1, 3> x =
        state.space.locate(fiber, s).position(state.fiber(fiber));
      return mesh.locate(x).cell != Textile::no_cell;
    }



    double
    CouplingPoints::surface_between(const unsigned int fiber,
                                    const double       inside,
                                    const double       outside) const
    {
      double last_within = inside, first_beyond = outside;
      for (unsigned int i = 0; i < n_halvings; ++i)
        {
          const double middle = 0.5 * (last_within + first_beyond);
          if (contains(fiber, middle))
            last_within = middle;
          else
            first_beyond = middle;
        }
      return last_within;
    }



    void
    CouplingPoints::add_piece(const unsigned int fiber,
                              const unsigned int n_points,
                              const double       begin,
                              const double       end)
    {
      const QGauss<1> gauss(n_points);
      for (unsigned int q = 0; q < n_points; ++q)
        {
          const double s = begin + (end - begin) * gauss.point(q)[0];
          add(fiber,
              s,
              state.space.locate(fiber, s),
              (end - begin) * gauss.weight(q));
        }
    }



    void
    CouplingPoints::add(const unsigned int           fiber,
                        const double                 s,
                        const System::MaterialPoint &particle,
                        const double                 length)
    {
      const Textile::PlaceInCell place =
        mesh.locate(particle.position(state.fiber(fiber)));
      if (place.cell == Textile::no_cell)
        return;
      const FiniteElement<3>      &shapes = matrix.shape_functions();
      Contributions::EmbeddedPoint point{
        fiber, particle, place.cell, {}, length};
      for (unsigned int a = 0; a < shapes.n_dofs_per_cell(); ++a)
        point.shapes.push_back(shapes.shape_value(a, place.unit));
      if (with_sections)
        {
          point.section   = state.space.locate_section(fiber, s);
          point.gradients = gradients(place);
        }
      found.push_back(point);
    }



    std::vector<Tensor<1, 3>>
    CouplingPoints::gradients(const Textile::PlaceInCell &place) const
    {
      const FiniteElement<3>   &shapes = matrix.shape_functions();
      std::vector<Tensor<1, 3>> in_cell;
      Tensor<2, 3>              jacobian;
      for (unsigned int a = 0; a < shapes.n_dofs_per_cell(); ++a)
        {
          in_cell.push_back(shapes.shape_grad(a, place.unit));
          jacobian += outer_product(
            in_cell.back(), matrix.reference(matrix.cell(place.cell)[a]));
        }
      const Tensor<2, 3> inverse = invert(jacobian);
      for (Tensor<1, 3> &gradient : in_cell)
        gradient = inverse * gradient;
      return in_cell;
    }
  } // namespace Simulation
} // namespace Heddle
