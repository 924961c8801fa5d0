// What: what one tile contributes to the complex, and the triangles that it owns as a mesh file of its own.
// Law:  a function of the points in its file.
// Cost: that of triangulating its points; memory as these, some hundred bytes each (budget.h).
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "rbpa/partial.h"
#include "stream/tile_file.h"
#include "stream/triangle_rows.h"

namespace rbpa::app {

/// By so many threads at most. Without triangles PartialAndItems::owned stays empty. Throws Cancelled, and InvalidInput
/// as partial() does.
PartialAndItems compute_tile(const Region& region, const IndexedPoints& points, double alpha, unsigned threads,
                             bool wants_triangles);

/// "tiles/*.ply" of tile 12 is "tiles/000012.ply".
std::string tile_mesh_path(const std::string& pattern, std::uint32_t tile);

/// PLY with the points that the triangles use, in the order of their indices. Requires: these are among `points`.
/// Throws Failure, Cancelled.
void write_tile_mesh(const std::string& path, const IndexedPoints& points, std::span<const TriangleRow> triangles);

}  // namespace rbpa::app
