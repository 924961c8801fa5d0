// What: what is wrong with where a mesh has its vertices, beside its topology.
// Law:  exact: no face and no vertex is reported because it nearly is so.
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
  std::vector<std::uint32_t> points;  ///< the corners of the face; all vertices at the place, ascending
  std::vector<std::size_t> faces;     ///< the face
};

std::string_view name(GeometryKind kind);

/// Faces first, in their order, then places in the order of their first vertices. A face with fewer than three corners,
/// or with one vertex twice, is a defect of topology and is passed over. Cost: linear. Throws Cancelled.
std::vector<GeometricDefect> find_geometric_defects(const MeshFile& mesh);

}  // namespace rbpa::app
