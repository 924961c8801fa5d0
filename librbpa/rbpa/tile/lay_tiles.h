// What:   the local part of a run: all that can be told tile by tile, laid on an empty front.
// Law:    what is laid is part of the solid alpha complex; nothing is missing at sites that are known.
// Source: docs/tiles.md.
#pragma once

#include "meshops/front/front.h"
#include "rbpa/predicate/radius.h"
#include "rbpa/search/point_grid.h"
#include "rbpa/tile/for_each_tile.h"

namespace rbpa {

/// Lays every tile, calling laid(const TileTriangles&) after each, one at a time and in any thread; it may throw to end the
/// run. Front::join() is left to the caller, who may have more to lay.
template <typename Laid>
void lay_tiles(const PointGrid<double>& grid, const Radius& radius, meshops::Front& front, Threads& threads,
               Laid laid) {
  front.reserve(3 * grid.points().size(), 2 * grid.points().size());
  for_each_tile<meshops::Placement>(
      grid, radius, threads, [](const TileTriangles&, meshops::Placement&) {},
      [&](const TileTriangles& tile, meshops::Placement& placement) {
        front.place(tile.patch, tile.outline, placement);
        laid(tile);
      },
      [&](const TileTriangles& tile, meshops::Placement& placement) {
        front.fill(tile.patch, tile.outline, placement);
      });
}

}  // namespace rbpa
