// What: all tiles, in several threads, told in one order.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "rbpa/parallel/in_order.h"
#include "rbpa/predicate/radius.h"
#include "rbpa/search/point_grid.h"
#include "rbpa/tile/cut.h"
#include "rbpa/tile/triangulate.h"

namespace rbpa {

inline constexpr std::uint32_t points_per_tile = 2048;  ///< measured: fewer have more seams, more leave the cache

/// Calls made(const TileTriangles&, Result&) with what each tile tells, in any thread; told(const TileTriangles&, Result&),
/// in the same order on every run and one at a time; then, in any thread, finish(const TileTriangles&, Result&). The
/// result is one tile's at a time, and is used again for others. Throws what one of them throws.
template <typename Result, typename Made, typename Told, typename Finish>
void for_each_tile(const PointGrid<double>& grid, const Radius& radius, Threads& threads, Made made, Told told,
                   Finish finish) {
  struct Workspace {
    Tile tile;
    TileWorkspace triangulation;
    std::optional<Cutter> cutter;
    TileTriangles triangles;
    Result result;
  };
  const std::vector<Block> all = blocks(grid, points_per_tile);
  in_order<Workspace>(
      threads, all.size(),
      [&](std::size_t i, Workspace& workspace) {
        if (!workspace.cutter) workspace.cutter.emplace(grid);
        workspace.cutter->cut(all[i], workspace.tile);
        triangulate(workspace.tile, radius, workspace.triangulation, workspace.triangles);
        made(std::as_const(workspace.triangles), workspace.result);
      },
      [&](std::size_t, Workspace& workspace) { told(std::as_const(workspace.triangles), workspace.result); },
      [&](std::size_t, Workspace& workspace) { finish(std::as_const(workspace.triangles), workspace.result); });
}

}  // namespace rbpa
