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

/// Lays every tile, calling laid() after each, which may throw to end the run.
/// Returns: of each site, whether every triangle at it is on the front.
template <typename Laid>
std::vector<bool> lay_tiles(const PointGrid<double>& grid, const Radius& radius, meshops::Front& front, Laid laid) {
  std::vector<bool> known(grid.points().size(), false);
  for_each_tile(grid, radius, [&](const TileTriangles& tile) {
    front.lay(tile.patch);
    for (const std::uint32_t s : tile.known) known[s] = true;
    laid();
  });
  front.join();
  return known;
}

}  // namespace rbpa
