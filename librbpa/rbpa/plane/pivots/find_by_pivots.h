// What:   finds the Delaunay triangles of a tile by ball pivoting, as far as the tile's points decide the triangles: a
//         finder (tile/finder.h).
// Law:    every triangle of the patch is one of the solid alpha complex of all points. A triangle is not left out if
//         its circumcircle lies where the tile has all points, unless more than 64 points lie about on this circle, or
//         no front of triangles of this kind leads to the triangle.
// Cost:   about two pivots a point, each a few vector instructions in single precision; exact arithmetic if single
//         precision leaves several points. See docs/explanation/plane.md, sections 6 to 11.
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
