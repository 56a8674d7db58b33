#include <heddle/textile/kept_cells.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace Heddle
{
  namespace Textile
  {
    namespace
    {
      /** Leave out the cells deep inside of one yarn. */
      void
      leave_out_inside(const LayeredGrid           &grid,
                       const std::vector<Point<3>> &positions,
                       const YarnBody              &body,
                       const double                 depth,
                       KeptCells                   &kept)
      {
        std::vector<bool> deep(grid.n_vertices());
        for (unsigned int v = 0; v < grid.n_vertices(); ++v)
          deep[v] = body.box().point_inside(positions[v]) &&
                    body.depth(positions[v]) > depth;
        for (unsigned int c = 0; c < grid.n_cells(); ++c)
          {
            const auto vertices = grid.vertices_of(c);
            if (std::all_of(
                  vertices.begin(),
                  vertices.end(),
                  [&deep](const unsigned int v) { return deep[v]; }) &&
                body.depth(grid.position(c, Point<3>(0.5, 0.5, 0.5))) > depth)
              kept[c] = false;
          }
      }



      /** Call @p visit with the number of every neighbour of a cell. */
      template <typename Visitor>
      void
      visit_neighbours(const LayeredGrid &grid,
                       const unsigned int cell,
                       const Visitor     &visit)
      {
        const auto index = grid.index_of_cell(cell);
        const auto n     = grid.n_along();
        for (unsigned int d = 0; d < 3; ++d)
          for (const int step : {-1, 1})
            if (step < 0 ? index[d] > 0 : index[d] + 1 < n[d])
              {
                auto neighbour = index;
                neighbour[d] += step;
                visit(grid.cell(neighbour));
              }
      }



      bool
      is_at_side(const LayeredGrid &grid, const unsigned int cell)
      {
        const auto index = grid.index_of_cell(cell);
        const auto n     = grid.n_along();
        return index[0] == 0 || index[0] + 1 == n[0] || index[1] == 0 ||
               index[1] + 1 == n[1];
      }



      /** Whether points that move with a body keep it from moving at all. */
      bool
      hold_a_body(const std::vector<Tensor<1, 3>> &points)
      {
        if (points.size() < 3)
          return false;
        Tensor<1, 3> longest;
        for (const Tensor<1, 3> &point : points)
          if ((point - points[0]).norm_square() > longest.norm_square())
            longest = point - points[0];
        constexpr double tolerance = 1e-3;
        return std::any_of(
          points.begin(), points.end(), [&](const Tensor<1, 3> &point) {
            return cross_product_3d(longest, point - points[0]).norm() >
                   tolerance * longest.norm_square();
          });
      }
    } // namespace



    KeptCells
    cells_outside_yarns(const LayeredGrid           &grid,
                        const std::vector<YarnBody> &bodies,
                        const double                 overlap_depth)
    {
      std::vector<Point<3>> positions(grid.n_vertices());
      for (unsigned int v = 0; v < grid.n_vertices(); ++v)
        positions[v] = grid.position(v);
      KeptCells kept(grid.n_cells(), true);
      for (const YarnBody &body : bodies)
        leave_out_inside(
          grid, positions, body, overlap_depth * body.fiber_radius(), kept);
      return kept;
    }



    Components
    connected_components(const LayeredGrid &grid, const KeptCells &kept)
    {
      AssertDimension(kept.size(), grid.n_cells());
      Components components;
      components.of_cell.assign(grid.n_cells(), no_cell);
      std::vector<unsigned int> front;
      for (unsigned int first = 0; first < grid.n_cells(); ++first)
        {
          if (!kept[first] || components.of_cell[first] != no_cell)
            continue;
          const unsigned int number = components.n_components++;
          const auto         reach  = [&](const unsigned int cell) {
            if (kept[cell] && components.of_cell[cell] == no_cell)
              {
                components.of_cell[cell] = number;
                front.push_back(cell);
              }
          };
          reach(first);
          while (!front.empty())
            {
              const unsigned int cell = front.back();
              front.pop_back();
              visit_neighbours(grid, cell, reach);
            }
        }
      return components;
    }



    DroppedCells
    drop_loose_components(const LayeredGrid               &grid,
                          const std::vector<Tensor<1, 3>> &nodes,
                          KeptCells                       &kept)
    {
      const Components  components = connected_components(grid, kept);
      std::vector<bool> is_held(components.n_components, false);
      for (unsigned int c = 0; c < grid.n_cells(); ++c)
        if (kept[c] && is_at_side(grid, c))
          is_held[components.of_cell[c]] = true;

      std::vector<std::vector<Tensor<1, 3>>> inside(components.n_components);
      for (const Tensor<1, 3> &node : nodes)
        {
          const unsigned int cell = grid.locate(node).cell;
          if (cell != no_cell && kept[cell])
            inside[components.of_cell[cell]].push_back(node);
        }
      DroppedCells dropped;
      for (unsigned int i = 0; i < components.n_components; ++i)
        {
          is_held[i] = is_held[i] || hold_a_body(inside[i]);
          dropped.n_components += is_held[i] ? 0 : 1;
        }
      for (unsigned int c = 0; c < grid.n_cells(); ++c)
        if (kept[c] && !is_held[components.of_cell[c]])
          {
            kept[c] = false;
            ++dropped.n_cells;
          }
      return dropped;
    }
  } // namespace Textile
} // namespace Heddle
