// What: all tiles, one after another.
#pragma once

#include "rbpa/pivot/radius.h"
#include "rbpa/search/point_grid.h"
#include "rbpa/tile/cut.h"
#include "rbpa/tile/triangulate.h"

namespace rbpa {

/// Calls visit(const TileTriangles&) with what each tile tells.
template <typename Visit>
void for_each_tile(const PointGrid<double>& grid, const Radius& radius, Visit visit) {
  constexpr std::uint32_t points_per_tile = 2048;  // measured: fewer have more seams, more do not fit the cache
  Cutter cutter(grid);
  Tile tile;
  TileTriangles triangles;
  TileWorkspace workspace;
  for (const Block& block : blocks(grid, points_per_tile)) {
    cutter.cut(block, tile);
    triangulate(tile, radius, workspace, triangles);
    visit(triangles);
  }
}

}  // namespace rbpa
