// What:   finds the Delaunay triangles of a tile by ball pivoting, as far as its points decide them: a finder
//         (tile/finder.h).
// Law:    every triangle of the patch is one of the solid alpha complex of all points. No triangle is left out whose
//         circumcircle lies where the tile has all points and to which a front of such triangles leads.
// Cost:   about two pivots a point, each a few vector instructions in single precision; exact arithmetic if these leave
//         two points. See docs/explanation/plane.md, sections 6 to 11.
// Source: Restricted BPA, sections 3.1 and 3.2.
#pragma once

#include <cstdint>
#include <vector>

#include "rbpa/plane/predicate/radius.h"
#include "rbpa/plane/tile/finder.h"

namespace rbpa {

struct PivotWorkspace {
  std::vector<std::uint16_t> queue, wave;  // sides of the front: those to be processed, and those in progress
  std::vector<float> circumradius;         // for each triangle
};

/// Finds the patch of a tile. Returns false, and leaves `found` unspecified, if points lie along curves, as triangles
/// then reach across empty regions, where a search from near to far takes long; or if searches have taken too long.
/// Requires: workspace.coordinates are those of the tile, which has points.
bool find_by_pivots(const Tile& tile, const Radius& alpha, TileWorkspace& workspace, PivotWorkspace& own,
                    TilePatch& found);

}  // namespace rbpa
