// What: finds geometric defects of a mesh: faces without area, and vertices at equal positions.
// Law:  the decisions are exact: a face with a small area is no defect, nor are vertices that are only near each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "io/mesh/read_mesh.h"

namespace rbpa::app {

enum class GeometryKind {
  zero_area_face,      ///< a face with all corners on one line
  coincident_vertices  ///< several vertices with equal coordinates
};

struct GeometricDefect {
  GeometryKind kind;
  std::vector<std::uint32_t> points;  ///< the corners of the face; or all vertices at the position, ascending
  std::vector<std::size_t> faces;     ///< the face; empty for coincident vertices
};

std::string_view name(GeometryKind kind);

/// Returns the faces without area, in ascending order, then the positions with several vertices, in the order of their
/// first vertices. Ignores faces with fewer than three corners or a repeated vertex, which are topological defects.
/// Cost: linear, and a sort of the coincident vertices. Throws Cancelled.
std::vector<GeometricDefect> find_geometric_defects(const MeshFile& mesh);

/// Returns the number of pairs of faces whose triangles cross, as crossing_triangles() defines it; stops at about
/// `most`. Faces of more than three corners are fans of triangles. Cost: that of crossing_triangles(). Throws
/// Cancelled.
std::size_t count_crossings(const MeshFile& mesh, std::size_t most);

}  // namespace rbpa::app
