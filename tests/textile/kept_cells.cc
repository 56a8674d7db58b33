// Cells are of one component if faces connect them; islands that no fiber holds
// are dropped, those at a side or with three nodes off a line are not.
#include <heddle/textile/kept_cells.h>

#include "../tests.h"

#include <algorithm>

using namespace Heddle::Textile;



/** A grid of n^3 unit cells. */
LayeredGrid
cube(const unsigned int n)
{
  ColumnGrid columns;
  columns.high      = {double(n), double(n)};
  columns.n_columns = {{n, n}};
  return LayeredGrid(columns,
                     std::vector<double>(columns.n_corners(), 0.),
                     std::vector<double>(columns.n_corners(), n),
                     n);
}



void
check(const std::string                     &name,
      const std::vector<Tensor<1, 3>>       &nodes,
      const std::vector<LayeredGrid::Index> &cells)
{
  const LayeredGrid grid = cube(5);
  KeptCells         kept(grid.n_cells(), false);
  for (const LayeredGrid::Index &index : cells)
    kept[grid.cell(index)] = true;
  const unsigned int n_before = connected_components(grid, kept).n_components;
  const DroppedCells dropped  = drop_loose_components(grid, nodes, kept);
  deallog << name << ": " << n_before << " components, dropped "
          << dropped.n_components << " of " << dropped.n_cells
          << " cells in all, left "
          << std::count(kept.begin(), kept.end(), true) << " cells in "
          << connected_components(grid, kept).n_components << std::endl;
}



int
main()
{
  initlog();
  const LayeredGrid::Index side = {{0, 2, 2}}, middle = {{2, 2, 2}},
                           top = {{2, 2, 3}}, diagonal = {{3, 3, 2}},
                           ceiling = {{1, 3, 4}};
  const Tensor<1, 3>              a({2.1, 2.1, 2.1}), b({2.5, 2.5, 2.5});
  const Tensor<1, 3>              c({2.9, 2.9, 2.9}), off({2.3, 2.9, 2.5});
  const std::vector<Tensor<1, 3>> line = {a, b, c}, three = {a, b, off};

  check("nothing", {}, {});
  check("at a side", {}, {side});
  check("island", {}, {side, middle});
  check("two cells", {}, {side, middle, top});
  check("by an edge only", {}, {side, middle, diagonal});
  check("below the surface only", {}, {side, ceiling});
  check("two nodes", {a, off}, {side, middle});
  check("three on a line", line, {side, middle});
  check("three nodes", three, {side, middle});
  check("one of two islands", three, {side, middle, diagonal});
  check("nodes elsewhere", three, {side, diagonal});
}
