// What: all tiles, in several threads, told in one order.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "meshops/front/placement.h"
#include "rbpa/parallel/in_order.h"
#include "rbpa/pivot/radius.h"
#include "rbpa/search/point_grid.h"
#include "rbpa/tile/cut.h"
#include "rbpa/tile/triangulate.h"

namespace rbpa {

inline constexpr std::uint32_t points_per_tile = 2048;  ///< measured: fewer have more seams, more leave the cache

/// What a tile tells, and what is known of its place in a mesh.
struct ToldTile {
  TileTriangles triangles;
  meshops::Placement placement;
};

/// Calls told(ToldTile&) with what each tile tells, in the same order on every run and one at a time; then, in any thread,
/// finish(ToldTile&). Throws what one of them throws.
template <typename Told, typename Finish>
void for_each_tile(const PointGrid<double>& grid, const Radius& radius, Threads& threads, Told told, Finish finish) {
  struct Workspace {
    Tile tile;
    TileWorkspace triangulation;
    std::optional<Cutter> cutter;
    ToldTile result;
  };
  const std::vector<Block> all = blocks(grid, points_per_tile);
  in_order<Workspace>(
      threads, all.size(),
      [&](std::size_t i, Workspace& workspace) {
        if (!workspace.cutter) workspace.cutter.emplace(grid);
        workspace.cutter->cut(all[i], workspace.tile);
        triangulate(workspace.tile, radius, workspace.triangulation, workspace.result.triangles);
      },
      [&](std::size_t, Workspace& workspace) { told(workspace.result); },
      [&](std::size_t, Workspace& workspace) { finish(workspace.result); });
}

/// Without what is done afterwards.
template <typename Told>
void for_each_tile(const PointGrid<double>& grid, const Radius& radius, Threads& threads, Told told) {
  for_each_tile(
      grid, radius, threads, [&](ToldTile& tile) { told(tile.triangles); }, [](ToldTile&) {});
}

}  // namespace rbpa
