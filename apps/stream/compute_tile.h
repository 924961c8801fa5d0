// What: computes the contribution of one tile to the complex, and writes the triangles that it owns as a mesh file.
// Law:  the result is a function of the points in the file of the tile.
// Cost: that of triangulating the points; memory of bytes_of_tile_point for each point (budget.h).
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "rbpa/plane/partial.h"
#include "stream/tile_file.h"
#include "stream/triangle_rows.h"

namespace rbpa::app {

/// Computes the tile whose box is `region`, by at most `threads` threads. PartialAndItems::owned is empty unless
/// `wants_triangles`.
/// Requires: `points` are all points of the file of the tile.
/// Throws:   InvalidInput as partial(); Cancelled.
PartialAndItems compute_tile(const Region& region, const IndexedPoints& points, double alpha, unsigned threads,
                             bool wants_triangles);

/// Returns the path of the mesh of a tile: "tiles/000012.ply" for "tiles/*.ply" and tile 12.
std::string tile_mesh_path(const std::string& pattern, std::uint32_t tile);

/// Writes a PLY with the points that `triangles` use, in the order of their indices. Requires: `points` contains these
/// points. Throws Failure, Cancelled.
void write_tile_mesh(const std::string& path, const IndexedPoints& points, std::span<const TriangleRow> triangles);

}  // namespace rbpa::app
