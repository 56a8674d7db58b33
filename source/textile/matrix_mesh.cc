#include <heddle/base/exceptions.h>
#include <heddle/textile/matrix_grid.h>
#include <heddle/textile/matrix_mesh.h>

#include <algorithm>

namespace Heddle
{
  namespace Textile
  {
    MatrixMesh::MatrixMesh(const MatrixMeshDescription     &description,
                           const std::vector<FiberAxis>    &fibers,
                           const std::vector<Tensor<1, 3>> &nodes,
                           const std::string               &where)
      : pattern({}, {0., 0., 0., 0.}, {1., 1., 1., 1.}, 1)
    {
      const std::vector<YarnBody> bodies = yarn_bodies(fibers);
      pattern = matrix_grid(description, fibers, bodies, where);
      KeptCells kept(pattern.n_cells(), true);
      if (description.leave_out)
        {
          kept =
            cells_outside_yarns(pattern, bodies, description.overlap_depth);
          n_inside = std::count(kept.begin(), kept.end(), false);
          loose    = drop_loose_components(pattern, nodes, kept);
        }
      number_cells(kept);
      require(!kept_cells.empty(),
              where + ": no cell is left beside the yarns; choose a larger "
                      "\"Overlap depth\", more \"Layers\", or set \"Leave out "
                      "cells inside yarns\" to false.");
      find_boundary();
    }



    void
    MatrixMesh::number_cells(const KeptCells &kept)
    {
      numbers_of_cells.assign(pattern.n_cells(), no_cell);
      std::vector<bool> used(pattern.n_vertices(), false);
      for (unsigned int c = 0; c < pattern.n_cells(); ++c)
        if (kept[c])
          {
            numbers_of_cells[c] = kept_cells.size();
            kept_cells.push_back({pattern.vertices_of(c), c});
            for (const unsigned int v : kept_cells.back().vertices)
              used[v] = true;
          }
      std::vector<unsigned int> new_number(pattern.n_vertices());
      for (unsigned int v = 0; v < pattern.n_vertices(); ++v)
        if (used[v])
          {
            new_number[v] = places.size();
            places.push_back(pattern.position(v));
          }
      for (Cell &cell : kept_cells)
        for (unsigned int &v : cell.vertices)
          v = new_number[v];
    }



    void
    MatrixMesh::find_boundary()
    {
      const auto n = pattern.n_along();
      for (unsigned int c = 0; c < kept_cells.size(); ++c)
        {
          const auto index = pattern.index_of_cell(kept_cells[c].number);
          for (unsigned int face = 0; face < 6; ++face)
            {
              const unsigned int d = face / 2;
              if (index[d] == (face % 2 == 0 ? 0 : n[d] - 1))
                {
                  faces.push_back({c, face, Side(face)});
                  continue;
                }
              auto neighbour = index;
              neighbour[d] += face % 2 == 0 ? -1 : 1;
              if (numbers_of_cells[pattern.cell(neighbour)] == no_cell)
                faces.push_back({c, face, inner});
            }
        }
    }



    PlaceInCell
    MatrixMesh::locate(const Tensor<1, 3> &point) const
    {
      PlaceInCell place = pattern.locate(point);
      if (place.cell != no_cell)
        place.cell = number_of(place.cell);
      return place;
    }



    double
    MatrixMesh::volume() const
    {
      double sum = 0.;
      for (const Cell &cell : kept_cells)
        sum += pattern.volume(cell.number);
      return sum;
    }
  } // namespace Textile
} // namespace Heddle
