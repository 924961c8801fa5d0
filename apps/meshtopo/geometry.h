// What: finds geometric defects of a mesh: faces without area, and vertices at equal positions.
// Law:  exact: no near miss is reported.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "io/mesh/read_mesh.h"

namespace rbpa::app {

enum class GeometryKind {
  zero_area_face,      ///< all corners lie on one line
  coincident_vertices  ///< vertices with the same coordinates
};

struct GeometricDefect {
  GeometryKind kind;
  std::vector<std::uint32_t> points;  ///< the corners of the face; all vertices at the position, ascending
  std::vector<std::size_t> faces;     ///< the face; empty for vertices
};

std::string_view name(GeometryKind kind);

/// Returns the faces without area in their order, then the shared positions in the order of their first vertices.
/// Ignores faces with fewer than three corners or with a vertex twice, which are topological defects. Cost: linear.
/// Throws Cancelled.
std::vector<GeometricDefect> find_geometric_defects(const MeshFile& mesh);

}  // namespace rbpa::app
