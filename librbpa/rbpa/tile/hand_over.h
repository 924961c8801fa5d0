// What: what a tile tells of the triangles found on it.
// Cost: linear in the points and triangles of the tile. As a tile's points come in no order that could be foreseen, lists
//       are written without branches: the next entry always, and counted if it is one.
#pragma once

#include "rbpa/predicate/radius.h"
#include "rbpa/tile/tile.h"
#include "rbpa/tile/triangulate.h"

namespace rbpa {

/// Of the triangles in workspace.front, those of the complex that the tile owns, and what is known around them.
/// Replaces `result`.
void hand_over(const Tile& tile, const Radius& radius, TileWorkspace& workspace, TileTriangles& result);

}  // namespace rbpa
