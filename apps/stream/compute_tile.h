// What: computes the contribution of one tile to the complex, and writes the triangles of the tile as a mesh file.
// Law:  the result depends only on the points in the file of the tile, on its box and on alpha.
// Cost: a triangulation of the points; memory of bytes_of_tile_point for each point (budget.h).
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "rbpa/plane/partial.h"
#include "stream/tile_file.h"
#include "stream/triangle_rows.h"

namespace rbpa::app {

/// Computes the tile whose box is `region`, by at most `threads` threads. PartialAndItems::owned, the triangles that
/// belong to this tile and no other, is empty unless `wants_triangles`.
/// Requires: `points` contains all points of the file of the tile.
/// Throws:   InvalidInput as partial() does; Cancelled.
PartialAndItems compute_tile(const Region& region, const IndexedPoints& points, double alpha, unsigned threads,
                             bool wants_triangles);

/// Returns the path of the mesh of a tile, with its number for the last '*': "tiles/000012.ply" for "tiles/*.ply".
std::string tile_mesh_path(const std::string& pattern, std::uint32_t tile);

/// Writes a PLY file of `triangles` and the points that they use, in the order of the point indices. Requires: `points`
/// contains all points that triangles use. Throws Failure, Cancelled.
void write_tile_mesh(const std::string& path, const IndexedPoints& points, std::span<const TriangleRow> triangles);

}  // namespace rbpa::app
