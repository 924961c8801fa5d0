// What: the triangles that a tile owns as a mesh file of its own.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "stream/pack_block.h"
#include "stream/triangle_rows.h"

namespace rbpa::app {

/// "tiles/*.ply" of tile 12 is "tiles/000012.ply".
std::string tile_mesh_path(const std::string& pattern, std::uint32_t tile);

/// PLY with the points that the triangles use, in the order of their indices. Requires: these are among `points`. Throws
/// Failure, Cancelled.
void write_tile_mesh(const std::string& path, const IndexedPoints& points, std::span<const TriangleRow> triangles);

}  // namespace rbpa::app
