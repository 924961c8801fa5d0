// What:   the local part of a run: all that can be told tile by tile, laid on an empty front.
// Law:    what is on the front afterwards is part of the solid alpha complex, and what is missing lies beyond active
//         halfedges or around sites that are not known.
// Source: docs/tiles.md.
#pragma once

#include <vector>

#include "meshops/front/front.h"
#include "rbpa/pivot/radius.h"
#include "rbpa/search/point_grid.h"
#include "rbpa/tile/for_each_tile.h"

namespace rbpa {

/// Lays every tile, calling laid() after each, one at a time and in any thread; it may throw to end the run.
/// Returns: of each site, whether every triangle at it is on the front.
template <typename Laid>
std::vector<bool> lay_tiles(const PointGrid<double>& grid, const Radius& radius, meshops::Front& front,
                            Threads& threads, Laid laid) {
  std::vector<bool> known(grid.points().size(), false);
  front.reserve(3 * known.size(), 2 * known.size());
  for_each_tile(
      grid, radius, threads,
      [&](ToldTile& tile) {
        front.place(tile.triangles.patch, tile.placement);
        for (const std::uint32_t s : tile.triangles.known) known[s] = true;
        laid();
      },
      [&](ToldTile& tile) { front.fill(tile.triangles.patch, tile.placement); });
  front.join();
  return known;
}

}  // namespace rbpa
