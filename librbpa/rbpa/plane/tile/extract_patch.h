// What: extracts the patch of a tile from the triangles found on it, and the status of the stars around its points.
// Cost: linear in the points and triangles of the tile. As the order of a tile's points is unpredictable, lists are
//       written without branches: the next entry is always written, and counted only if it belongs to the list.
#pragma once

#include <cstdint>
#include <vector>

#include "rbpa/plane/predicate/radius.h"
#include "rbpa/plane/tile/circumradius_filter.h"
#include "rbpa/plane/tile/coordinates.h"
#include "rbpa/plane/tile/local_front.h"
#include "rbpa/plane/tile/tile.h"
#include "rbpa/plane/tile/tile_patch.h"

namespace rbpa {

/// Memory that is reused from tile to tile; extract_patch.cpp defines its use.
struct ExtractionWorkspace {
  std::vector<std::uint16_t> kept, others, marginal;  // numbers of triangles
  std::vector<std::uint16_t> owned;                   // for each triangle: 1 if the tile owns its least corner, else 0
  std::vector<std::uint16_t> number;                  // for each side: the entry of the side across
  std::vector<std::uint16_t> elsewhere;               // for each point: triangles around it that other tiles own
  // For each point: the side that leaves it in an outline, or a side of the rim that ends there.
  std::vector<int> last, ending;
  std::vector<CircumradiusFilter> within;  // for each triangle, how its circumradius compares with alpha
  std::vector<std::uint8_t> star;          // for each point, its status
  // lists of the result, before their length is known
  std::vector<std::uint32_t> settled, ghost_corners;
  std::vector<TilePatch::SharedStar> shared;
  std::vector<TilePatch::Neighbors> unsettled_neighbors;
  std::vector<int> outer;
};

/// Replaces `result` by the triangles of the front that have circumradius ≤ alpha and that the tile owns, and by the
/// sites whose stars are settled (tile_patch.h).
/// Requires: `coordinates` are those of the tile.
void extract_patch(const Tile& tile, const TileCoordinates& coordinates, const LocalFront& front, const Radius& alpha,
                   ExtractionWorkspace& workspace, TilePatch& result);

}  // namespace rbpa
