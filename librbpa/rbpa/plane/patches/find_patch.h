// What: finds the patch of a tile: by enumeration if that suits the tile, otherwise by pivots (tile/finder.h).
#pragma once

#include "rbpa/plane/enumeration/find_by_enumeration.h"
#include "rbpa/plane/pivots/find_by_pivots.h"
#include "rbpa/plane/tile/finder.h"

namespace rbpa {

struct FinderWorkspace {
  TileWorkspace tile;
  EnumerationWorkspace enumeration;
  PivotWorkspace pivots;
};

/// Replaces `found` by the patch of a tile; the patch is empty if both finders give up.
inline void find_patch(const Tile& tile, const Radius& alpha, FinderWorkspace& workspace, TilePatch& found) {
  if (tile.points.empty()) return found.clear();
  workspace.tile.coordinates.assign(tile);
  if (!find_by_enumeration(tile, alpha, workspace.tile, workspace.enumeration, found) &&
      !find_by_pivots(tile, alpha, workspace.tile, workspace.pivots, found))
    found.clear();
}

}  // namespace rbpa
