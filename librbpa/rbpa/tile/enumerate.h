// What: the triangles of a small solid alpha complex on a tile, found by enumeration.
// Law:  every triangle of the complex of which the tile owns a corner is found, and no other.
// Why:  a front that advances finds the whole Delaunay triangulation, also where alpha leaves little of it. Where a point
//       has a handful of others within 2 alpha, it is sooner said which of them form a triangle with it.
// Cost: for each point, with m others within 2 alpha: O(m³), in vectors; a few dozen nanoseconds up to m = 6.
#pragma once

#include "rbpa/predicate/radius.h"
#include "rbpa/tile/tile.h"
#include "rbpa/tile/triangulate.h"

namespace rbpa {

/// Replaces the workspace's front, and its `near_rim` by pairs of sites at most, about, 2 alpha apart: all of which the
/// tile owns one and another tile the other, and more. False where a search would not pay or would need points that the
/// tile does not have: what the workspace then has of these is of no use. Requires its coordinates.
bool enumerate(const Tile& tile, const Radius& radius, TileWorkspace& workspace);

}  // namespace rbpa
